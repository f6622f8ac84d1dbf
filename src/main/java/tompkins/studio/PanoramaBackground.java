package tompkins.studio;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;

/** A picture of all directions: columns are longitudes, the middle one along z; rows are latitudes, the top one up. */
@Meaning("A picture of all directions; its middle is seen along z, columns are longitudes, rows latitudes")
public record PanoramaBackground(
        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture,

        @Meaning(
                "Whether each pixel shows the mean of what it sees of the picture, which is smooth between its own pixels")
        boolean filtered)
        implements Background {

    /** White. */
    public static final PanoramaBackground DEFAULT = new PanoramaBackground(PixelPicture.WHITE, true);

    @Override
    public Colour colour(double dx, double dy, double dz, double angle) {
        double longitude = Math.atan2(dx, dz) / (2 * Math.PI) + 0.5;
        double fromAxis = Math.hypot(dx, dz);
        double latitude = Math.atan2(dy, fromAxis) / Math.PI + 0.5;
        if (!filtered) {
            return picture.pixel(longitude, latitude).light();
        }
        double half = angle / 2;
        return picture.mean(longitude, latitude, half / (2 * Math.PI * fromAxis), half / Math.PI, true)
                .light();
    }
}
