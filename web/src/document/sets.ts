/** Whether every item of `part` is in `whole`. */
export function isWithin<T>(part: ReadonlySet<T>, whole: ReadonlySet<T>): boolean {
  return part.size <= whole.size && [...part].every((item) => whole.has(item));
}

export function areSame<T>(one: ReadonlySet<T>, other: ReadonlySet<T>): boolean {
  return one.size === other.size && isWithin(one, other);
}

export function without<T>(set: ReadonlySet<T>, gone: ReadonlySet<T>): Set<T> {
  return new Set([...set].filter((item) => !gone.has(item)));
}

export function common<T>(one: ReadonlySet<T>, other: ReadonlySet<T>): Set<T> {
  return new Set([...one].filter((item) => other.has(item)));
}

/** Those in exactly one of the two. */
export function toggled<T>(one: ReadonlySet<T>, other: ReadonlySet<T>): Set<T> {
  return new Set([...without(one, other), ...without(other, one)]);
}
