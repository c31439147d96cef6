/** A ref that stands an element at a place of the track. Positions go through the CSSOM: the page allows no style attributes. */
export function placed(left: number, width?: number): (element: HTMLElement | null) => void {
  return (element) => {
    if (!element) return;
    element.style.transform = `translateX(${left}px)`;
    if (width !== undefined) element.style.width = `${width}px`;
  };
}
