package tompkins.ray;

/**
 * What a spot of a picture shows.
 *
 * @param light its mean colour, multiplied by the opacity
 * @param opacity from 0, not there, to 1
 */
public record Texel(Colour light, double opacity) {}
