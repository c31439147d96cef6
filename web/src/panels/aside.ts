/** What a person looks at beside the show itself, one at a time; null: nothing. */
export interface Aside {
  /** `original`: the recording beside the motion made from it, without its panel. */
  readonly kind: "modes" | "recording" | "original";
}
