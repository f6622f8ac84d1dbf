package tompkins.ray;

/**
 * What some triangles of a mesh look like.
 *
 * @param name as the file calls it
 * @param diffuse colour in diffuse light
 * @param specular colour of highlights
 * @param opacity from 0, not there, to 1
 * @param picture what is seen where they have places in it, with the diffuse colour and the opacity in it, or null
 */
public record MeshMaterial(String name, Colour diffuse, Colour specular, double opacity, PixelPicture picture) {}
