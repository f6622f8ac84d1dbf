package tompkins.surface;

import java.util.stream.Stream;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** What a boundary looks like and what it does to light. Descriptions, immutable, checked when they are made. */
public sealed interface Surface
        permits ColouredSurface,
                LuminousSurface,
                PictureSurface,
                CompositeSurface,
                Clear,
                ColourFilter,
                Mirror,
                Refractive,
                ComplexRefraction,
                FrameWindow,
                ConfocalLensletArray,
                IdealLens,
                AddedSurface {

    /** What becomes of a ray that hit this surface. */
    Response respond(Ray ray, Hit hit, Tracer tracer);

    /** Whether the surface needs {@link Hit#coordinates}. */
    default boolean usesCoordinates() {
        return false;
    }

    /** Whether the surface throws a shadow; most surfaces behind which rays go on throw none. */
    default Shadow shadow() {
        return continuation() == Continuation.NONE ? Shadow.ALWAYS : Shadow.NEVER;
    }

    /**
     * Whether the surface throws a shadow at a hit. Surfaces with {@link Shadow#BY_POINT} say where.
     *
     * @param ray the ray that hit it, from what may lie in its shadow towards the light
     */
    default boolean throwsShadowAt(Ray ray, Hit hit) {
        return switch (shadow()) {
            case ALWAYS -> true;
            case NEVER -> false;
            case BY_POINT -> throw new IllegalStateException(getClass() + " does not say where it throws a shadow");
        };
    }

    /** The surfaces that this one shows, each with its own parts; itself if it shows no others. */
    default Stream<Surface> parts() {
        return Stream.of(this);
    }

    /** Whether it looks different at different times. */
    default boolean showsTime() {
        return false;
    }

    /** Whether it may be on what turns: a law that is given for an inertial frame has no meaning there. */
    default boolean canTurn() {
        return true;
    }

    /** What becomes of the rays that meet it. */
    default Continuation continuation() {
        return Continuation.NONE;
    }

    /**
     * Whether light takes the way of stationary time, as that of a wave does with mirrors and glass. What turns rays
     * and leaves the time of the light as it is does not: signals arrive at another rate there than crests.
     */
    default boolean keepsPhase() {
        return continuation() != Continuation.TURNED;
    }
}
