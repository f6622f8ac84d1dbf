package tompkins.surface;

import java.util.stream.Stream;
import tompkins.property.Meaning;
import tompkins.property.Require;
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
        implements Surface {

    /** Nothing is cut out. */
    public static final CutOut DEFAULT =
            new CutOut(PixelPicture.WHITE, new ColouredSurface(Colour.BLACK, Colour.BLACK), Clear.DEFAULT);

    /** Checks that nothing is missing. */
    public CutOut {
        Require.present("picture", picture);
        Require.present("dark", dark);
        Require.present("bright", bright);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return at(hit).respond(ray, hit, tracer);
    }

    private Surface at(Hit hit) {
        double u = PictureSurface.inside(hit.coordinates.u());
        double v = PictureSurface.inside(hit.coordinates.v());
        return picture.isDark(u, v) ? dark : bright;
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    @Override
    public Shadow shadow() {
        return dark.shadow().orElsewhere(bright.shadow());
    }

    @Override
    public boolean throwsShadowAt(Ray ray, Hit hit) {
        return at(hit).throwsShadowAt(ray, hit);
    }

    @Override
    public Stream<Surface> parts() {
        return Stream.of(dark, bright).flatMap(Surface::parts);
    }

    @Override
    public boolean showsTime() {
        return dark.showsTime() || bright.showsTime();
    }

    @Override
    public boolean continuesRays() {
        return dark.continuesRays() || bright.continuesRays();
    }
}
