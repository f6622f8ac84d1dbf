package tompkins.ray;

import java.util.Arrays;

/**
 * A picture as numbers, with the file that it came from. Pixels are red, green, blue, opacity; row 0 is at the top.
 * Immutable: the arrays are handed over and must not be changed afterwards.
 */
public final class PixelPicture implements FileContent {

    /** One white pixel, for descriptions that still need a picture. */
    public static final PixelPicture WHITE = new PixelPicture("", 1, 1, new float[] {1, 1, 1, 1}, new byte[0]);

    /** A little below 127/255, so that no rounding decides about a level of 8 bits. */
    private static final float LEAST_BRIGHT = 0.498f;

    private final String name;
    private final int width;
    private final int height;
    private final float[] rgba;
    private final byte[] file;
    private final boolean opaque;

    /** Made when it is needed first. */
    private volatile MipMap scales;

    /**
     * A picture of {@code width} by {@code height} pixels.
     *
     * @param name the file's name, as the scene file writes it
     * @param rgba four numbers a pixel, colours not multiplied by the opacity
     * @param file the bytes of the picture file
     * @throws IllegalArgumentException if the number of values does not fit the size
     */
    public PixelPicture(String name, int width, int height, float[] rgba, byte[] file) {
        if (width < 1 || height < 1 || (long) width * height * 4 != rgba.length) {
            throw new IllegalArgumentException(
                    name + ": " + rgba.length + " values do not fill " + width + " x " + height + " pixels");
        }
        this.name = name;
        this.width = width;
        this.height = height;
        this.rgba = rgba;
        this.file = file;
        this.opaque = isOpaque(rgba);
    }

    private static boolean isOpaque(float[] rgba) {
        for (int opacity = 3; opacity < rgba.length; opacity += 4) {
            if (rgba[opacity] < 1) {
                return false;
            }
        }
        return true;
    }

    @Override
    public String name() {
        return name;
    }

    /** Pixels in a row. */
    public int width() {
        return width;
    }

    /** Number of rows. */
    public int height() {
        return height;
    }

    @Override
    public byte[] file() {
        return file.clone();
    }

    @Override
    public int length() {
        return file.length;
    }

    /** The colour of the pixel that holds (u, v): u from 0 at the left to 1, v from 0 at the bottom to 1. */
    public Colour colour(double u, double v) {
        int index = index(u, v);
        return new Colour(rgba[index], rgba[index + 1], rgba[index + 2]);
    }

    /** Whether it is opaque everywhere. */
    public boolean isOpaque() {
        return opaque;
    }

    /** The same picture, with its colours and its opacity multiplied. */
    public PixelPicture tinted(Colour colour, double opacity) {
        if (colour.equals(Colour.WHITE) && opacity == 1) {
            return this;
        }
        float[] tinted = rgba.clone();
        double[] factors = {colour.red(), colour.green(), colour.blue(), opacity};
        for (int i = 0; i < tinted.length; i++) {
            tinted[i] *= (float) factors[i % factors.length];
        }
        return new PixelPicture(name, width, height, tinted, file);
    }

    /** The pixel that holds (u, v). */
    public Texel pixel(double u, double v) {
        double opacity = rgba[index(u, v) + 3];
        return new Texel(opacity == 1 ? colour(u, v) : colour(u, v).times(opacity), opacity);
    }

    /**
     * The mean over a spot, interpolated between the pixels.
     *
     * @param halfU half the extent of the spot along u
     * @param halfV half the extent along v
     * @param isRound whether the right edge of the picture is followed by its left one, as around an axis
     */
    public Texel mean(double u, double v, double halfU, double halfV, boolean isRound) {
        MipMap known = scales;
        if (known == null) {
            synchronized (file) {
                known = scales == null ? new MipMap(width, height, rgba, opaque) : scales;
                scales = known;
            }
        }
        return known.mean(u, v, halfU, halfV, isRound);
    }

    /** Whether (u, v) is dark and opaque: opacity at least 1/2, luminance of its numbers below 127/255. */
    public boolean isDark(double u, double v) {
        int index = index(u, v);
        double luminance = Colour.luminance(rgba[index], rgba[index + 1], rgba[index + 2]);
        return rgba[index + 3] >= 0.5f && luminance < LEAST_BRIGHT;
    }

    private int index(double u, double v) {
        int column = Math.max(0, Math.min(width - 1, (int) (u * width)));
        int row = Math.max(0, Math.min(height - 1, (int) ((1 - v) * height)));
        return 4 * (row * width + column);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PixelPicture picture && name.equals(picture.name) && Arrays.equals(file, picture.file);
    }

    @Override
    public int hashCode() {
        return name.hashCode() * 31 + Arrays.hashCode(file);
    }

    @Override
    public String toString() {
        return name + " (" + width + " x " + height + ")";
    }
}
