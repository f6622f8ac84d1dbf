package tompkins.render;

/** Light for films, as tests have it. */
final class Films {

    private Films() {}

    /** Adds a sample of a pixel, or several that are equal, by the sum of their light. */
    static void add(PixelBuffer film, int pixel, double red, double green, double blue, int added) {
        film.add(pixel, red, green, blue, Film.squared(red, green, blue) / added, added);
    }
}
