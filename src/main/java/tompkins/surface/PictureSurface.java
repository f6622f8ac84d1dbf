package tompkins.surface;

import tompkins.light.Illumination;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.PixelPicture;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;
import tompkins.ray.Texel;

/**
 * A picture laid over the surface once, from coordinate 0 to 1 in both directions, and repeated beyond. Where it is not
 * opaque, the rest of the light comes from behind, and it throws no shadow.
 */
@Meaning("A picture that covers the surface once, from coordinate 0 to 1, and repeats beyond;"
        + " where it is not opaque one sees through it")
public record PictureSurface(
        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture,

        @Meaning("Whether the picture glows by itself; otherwise light sources light it")
        boolean luminous,

        @Meaning(
                "Whether each pixel shows the mean of what it sees of the picture, which is smooth between its own pixels")
        boolean filtered,

        @Meaning("Whether it is laid on mirrored, so that it reads right from inside or behind")
        boolean mirrored)
        implements Surface {

    /** From here on the rest is rounding. */
    private static final double OPAQUE = 1 - 1e-6;

    /** One white pixel. */
    public static final PictureSurface DEFAULT = new PictureSurface(PixelPicture.WHITE, false, true);

    /** A picture that reads right from outside. */
    public PictureSurface(PixelPicture picture, boolean luminous, boolean filtered) {
        this(picture, luminous, filtered, false);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        Texel texel = filtered ? spot(ray, hit) : at(hit);
        Illumination illumination = tracer.illumination();
        Colour light = luminous
                ? illumination.emitted(ray, texel.light())
                : illumination.reflected(ray, hit, texel.light(), Colour.BLACK);
        if (texel.opacity() > OPAQUE) {
            return Response.ends(light);
        }
        double clear = 1 - texel.opacity();
        return new Response(light, Colour.grey(clear), ray.straightOn(hit, clear));
    }

    /** The picture at the hit itself. */
    private Texel at(Hit hit) {
        double u = inside(across(hit));
        double v = inside(hit.coordinates.v());
        return filtered ? picture.mean(u, v, 0, 0, false) : picture.pixel(u, v);
    }

    /** The first coordinate in the picture. */
    private double across(Hit hit) {
        return mirrored ? 1 - hit.coordinates.u() : hit.coordinates.u();
    }

    /** The mean over the spot of the ray, which is taken in parts along its long axis. */
    private Texel spot(Ray ray, Hit hit) {
        SurfaceCoordinates at = hit.coordinates;
        double atU = across(hit);
        double alongU = mirrored ? -at.alongU(ray, hit) : at.alongU(ray, hit);
        double alongV = at.alongV(ray, hit);
        double pixels = 2 * Math.hypot(alongU * picture.width(), alongV * picture.height());
        double slant = Math.ceil(Math.min(pixels, 1 / Math.abs(hit.cosine(ray))));
        int parts = (int) Math.max(1, Math.min(Tiling.MOST_PARTS, slant));
        double spreadU = at.spreadU(ray, hit);
        double spreadV = at.spreadV(ray, hit);
        double halfU = Tiling.partSpread(spreadU, alongU, parts);
        double halfV = Tiling.partSpread(spreadV, alongV, parts);
        // a small spot ends at the edges of its copy
        double copyU = atU - inside(atU);
        double copyV = at.v() - inside(at.v());
        Colour light = Colour.BLACK;
        double opacity = 0;
        for (int part = 0; part < parts; part++) {
            double place = (2.0 * part + 1) / parts - 1;
            double u = atU + place * alongU;
            double v = at.v() + place * alongV;
            Texel texel = picture.mean(
                    spreadU < 0.5 ? u - copyU : inside(u), spreadV < 0.5 ? v - copyV : inside(v), halfU, halfV, false);
            light = light.plus(texel.light().times(1.0 / parts));
            opacity += texel.opacity() / parts;
        }
        return new Texel(light, opacity);
    }

    @Override
    public boolean usesCoordinates() {
        return true;
    }

    @Override
    public Shadow shadow() {
        return picture.isOpaque() ? Shadow.ALWAYS : Shadow.BY_POINT;
    }

    @Override
    public boolean throwsShadowAt(Ray ray, Hit hit) {
        return at(hit).opacity() > OPAQUE;
    }

    @Override
    public Continuation continuation() {
        return picture.isOpaque() ? Continuation.NONE : Continuation.STRAIGHT;
    }

    /** The coordinate taken back into one copy of the picture; 1 itself belongs to the first copy. */
    static double inside(double coordinate) {
        return coordinate == 1 ? 1 : coordinate - Math.floor(coordinate);
    }
}
