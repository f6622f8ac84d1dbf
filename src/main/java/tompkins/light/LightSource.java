package tompkins.light;

import java.util.stream.Stream;

/** A source of light: one at rest, or several that move. */
public sealed interface LightSource permits RestingLight, MovingLights {

    /** Its lights, as if they rested where they are at time 0 of the frame around them. */
    Stream<RestingLight> atRest();
}
