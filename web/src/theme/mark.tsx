/** From faint to firm: where an agent was, how it came, where it is. */
export function Mark() {
  return (
    <svg class="mark" viewBox="0 0 26 20" width="26" height="20" aria-hidden="true">
      <defs>
        <linearGradient id="mark-trail" gradientUnits="userSpaceOnUse" x1="5" y1="14.5" x2="20.5" y2="6">
          <stop offset="0" stop-color="currentColor" stop-opacity="0.08" />
          <stop offset="1" stop-color="currentColor" stop-opacity="0.85" />
        </linearGradient>
      </defs>
      <circle cx="5" cy="14.6" r="3.9" fill="currentColor" opacity="0.26" />
      <path d="M5 14.2C9.4 13.6 11.6 6.6 18.6 2.7l3 5.6C15.6 9.6 11 14.6 5 15z" fill="url(#mark-trail)" />
      <circle cx="20.6" cy="6" r="4.3" fill="currentColor" />
    </svg>
  );
}
