import "./inspector.css";

/** What is selected, and what can be changed about it. */
export function Inspector() {
  return <section class="side" aria-label="Inspector" />;
}
