package tompkins.experiment;

import java.util.Locale;

/**
 * A place in a picture.
 *
 * @param across share of the width from the left, 0 to 1
 * @param down share of the height from the top, 0 to 1
 */
record Place(double across, double down) {

    /** Pixels from the left in a picture of a width. */
    double x(int width) {
        return across * width;
    }

    /** Pixels from the top in a picture of a height. */
    double y(int height) {
        return down * height;
    }

    /** The place on the way to another one, at a share of that way. */
    Place towards(Place other, double share) {
        return new Place(across + share * (other.across - across), down + share * (other.down - down));
    }

    /** The place in the form that messages use. */
    String text() {
        return String.format(Locale.ROOT, "across %.4g, down %.4g", across, down);
    }
}
