package tompkins.surface;

import java.util.List;
import tompkins.light.LightSource;
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
        return Response.ends(lit(ray, hit, tracer, diffuse, specular));
    }

    /** The light that comes back from a point with the given colours. */
    static Colour lit(Ray ray, Hit hit, Tracer tracer, Colour diffuse, Colour specular) {
        List<LightSource> lights = tracer.lights();
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = 0; i < lights.size(); i++) {
            Colour part = lights.get(i).reflected(ray, hit, diffuse, specular, tracer);
            red += part.red();
            green += part.green();
            blue += part.blue();
        }
        return new Colour(red, green, blue);
    }
}
