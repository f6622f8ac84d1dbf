package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Not there: rays and light pass unchanged. The holes of cut-outs and tilings are made of it. */
@Meaning("Not there: rays and light pass unchanged; for the holes of cut-outs and tilings")
public record Clear() implements Surface {

    /** The only one. */
    public static final Clear DEFAULT = new Clear();

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return Response.goesOn(ray.straightOn(hit, 1), Colour.WHITE);
    }

    @Override
    public Continuation continuation() {
        return Continuation.STRAIGHT;
    }
}
