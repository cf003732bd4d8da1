/** How much of a stranger's file the page takes. */

/** Tables of the scene and the drawn mesh together then take about 500 MB. */
export const mostTriangles = 400000;
/** Of all pictures of a model, and of an environment: 16 bytes each on the graphics card. */
export const mostTexels = 2 ** 22;
/** Of a picture before it is made smaller. */
export const mostPixels = 2 ** 26;
