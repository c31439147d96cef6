/** What a person looks at beside the show itself, one at a time; null: nothing. */
export type Aside = { readonly kind: "modes" };
