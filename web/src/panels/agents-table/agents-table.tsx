/** Everybody. */
export function AgentsTable() {
  return <p />;
}
