package tompkins.image;

/** Temporary. */
public record LinearImage(int width, int height, float[] rgb) {}
