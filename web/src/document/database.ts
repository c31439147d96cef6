/** The name of the page's database on this device. */
export const DATABASE = "eigenform";
