package tompkins.studio;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;

/** A picture of all directions: columns are longitudes, the middle one along z; rows are latitudes, the top one up. */
@Meaning("A picture of all directions; its middle is seen along z, columns are longitudes, rows latitudes")
public record PanoramaBackground(
        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture) implements Background {

    /** White. */
    public static final PanoramaBackground DEFAULT = new PanoramaBackground(PixelPicture.WHITE);

    /** Checks that there is a picture. */
    public PanoramaBackground {
        Require.present("picture", picture);
    }

    @Override
    public Colour colour(double dx, double dy, double dz) {
        double longitude = Math.atan2(dx, dz) / (2 * Math.PI) + 0.5;
        double latitude = Math.atan2(dy, Math.hypot(dx, dz)) / Math.PI + 0.5;
        return picture.colour(longitude, latitude);
    }
}
