package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A thin sheet of coloured glass: light goes straight through and is dimmed channel by channel. */
@Meaning("A thin coloured glass: rays go straight on, each channel is dimmed")
public record ColourFilter(
        @Meaning("Share of the light that passes, in each channel, from 0 to 1")
        Colour transmission) implements Surface {

    /** Clear glass. */
    public static final ColourFilter DEFAULT = new ColourFilter(Colour.WHITE);

    /** Checks that no channel is brightened. */
    public ColourFilter {
        Require.within("transmission (red)", transmission.red(), 0.0, 1.0);
        Require.within("transmission (green)", transmission.green(), 0.0, 1.0);
        Require.within("transmission (blue)", transmission.blue(), 0.0, 1.0);
    }

    @Override
    public Response respond(Ray ray, Hit hit, Tracer tracer) {
        return Response.goesOn(ray.straightOn(hit, transmission.brightest()), transmission);
    }

    @Override
    public Continuation continuation() {
        return Continuation.STRAIGHT;
    }
}
