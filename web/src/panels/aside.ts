/** What a person looks at beside the show itself, one at a time; null: nothing. */
export interface Aside {
  /**
   * `original`: the recording beside the motion made from it, without its panel; `assignment`: who would go where, told
   * in the inspector; `path`: what a formation travels along, told there, too.
   */
  readonly kind: "modes" | "recording" | "original" | "assignment" | "path";
}
