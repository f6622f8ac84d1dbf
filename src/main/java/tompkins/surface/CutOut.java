package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.PixelPicture;
import tompkins.ray.Ray;

/** Two surfaces, one where a picture is dark and one where it is bright: a silhouette if the bright part is clear. */
@Meaning("Two surfaces: one where a picture is dark, one where it is bright or transparent")
public record CutOut(
        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture,

        @Meaning("Surface where the picture is dark") Surface dark,

        @Meaning("Surface where the picture is bright or transparent")
        Surface bright)
        implements CompositeSurface {

    /** Nothing is cut out. */
    public static final CutOut DEFAULT =
            new CutOut(PixelPicture.WHITE, new ColouredSurface(Colour.BLACK, Colour.BLACK), Clear.DEFAULT);

    @Override
    public Surface first() {
        return dark;
    }

    @Override
    public Surface second() {
        return bright;
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        double u = PictureSurface.inside(hit.coordinates.u());
        double v = PictureSurface.inside(hit.coordinates.v());
        return picture.isDark(u, v) ? 0 : 1;
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }
}
