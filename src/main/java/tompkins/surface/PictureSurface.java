package tompkins.surface;

import tompkins.light.Illumination;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.PixelPicture;
import tompkins.ray.Ray;

/** A picture laid over the surface once, from coordinate 0 to 1 in both directions, and repeated beyond. */
@Meaning("A picture that covers the surface once, from coordinate 0 to 1, and repeats beyond")
public record PictureSurface(
        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture,

        @Meaning("Whether the picture glows by itself; otherwise light sources light it")
        boolean luminous)
        implements Surface {

    /** One white pixel. */
    public static final PictureSurface DEFAULT = new PictureSurface(PixelPicture.WHITE, false);

    /** Checks that there is a picture. */
    public PictureSurface {
        Require.present("picture", picture);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        double u = hit.coordinates.u();
        double v = hit.coordinates.v();
        Colour colour = picture.colour(inside(u), inside(v));
        Illumination illumination = tracer.illumination();
        return Response.ends(
                luminous ? illumination.emitted(ray, colour) : illumination.reflected(ray, hit, colour, Colour.BLACK));
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    /** The coordinate taken back into one copy of the picture; 1 itself belongs to the first copy. */
    static double inside(double coordinate) {
        return coordinate == 1 ? 1 : coordinate - Math.floor(coordinate);
    }
}
