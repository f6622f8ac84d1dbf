package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A dull or shiny colour, the same on both sides, lit by the lamps of the scene. */
@Meaning("A dull or shiny colour, the same on both sides, lit by the light sources")
public record ColouredSurface(
        @Meaning("Colour in diffuse light") Colour diffuse,
        @Meaning("Colour of the highlights") Colour specular) implements Surface {

    /** Dull light grey. */
    public static final ColouredSurface DEFAULT = new ColouredSurface(Colour.grey(0.8), Colour.BLACK);

    /** Checks the colours. */
    public ColouredSurface {
        Colour.required("diffuse", diffuse);
        Colour.required("specular", specular);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return Response.ends(tracer.illumination().reflected(ray, hit, diffuse, specular));
    }
}
