package tompkins.surface;

import java.util.stream.Stream;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** A surface that shows two others: at each hit one of them, or both, each with a fraction of the light. */
public sealed interface CompositeSurface extends Surface permits Tiling, CutOut, Clock, Blinking, TwoSided, Mixture {

    /** One of the surfaces. */
    Surface first();

    /** The other one. */
    Surface second();

    /** The fraction of the second surface at a hit, from 0 to 1. */
    double fractionOfSecond(Ray ray, Hit hit);

    /** Each surface answers for its fraction of the bundle; the tracer loops over the larger fraction. */
    @Override
    default Response respond(Ray ray, Hit hit, Tracer tracer) {
        double fraction = fractionOfSecond(ray, hit);
        if (fraction == 0) {
            return first().respond(ray, hit, tracer);
        }
        if (fraction == 1) {
            return second().respond(ray, hit, tracer);
        }
        if (continuation() != Continuation.NONE && ray.throughput * Math.min(fraction, 1 - fraction) < Ray.FAINTEST) {
            // a fraction too faint to be followed is added to the larger one
            return (fraction < 0.5 ? first() : second()).respond(ray, hit, tracer);
        }
        Response ofFirst =
                first().respond(ray.dimmed(1 - fraction), hit, tracer).times(1 - fraction);
        Response ofSecond = second().respond(ray.dimmed(fraction), hit, tracer).times(fraction);
        return fraction < 0.5 ? ofFirst.plus(ofSecond, tracer) : ofSecond.plus(ofFirst, tracer);
    }

    @Override
    default boolean usesCoordinates() {
        return first().usesCoordinates() || second().usesCoordinates();
    }

    @Override
    default Shadow shadow() {
        return first().shadow().orElsewhere(second().shadow());
    }

    /** Where light passes one of both there is no shadow. */
    @Override
    default boolean throwsShadowAt(Ray ray, Hit hit) {
        double fraction = fractionOfSecond(ray, hit);
        return (fraction == 1 || first().throwsShadowAt(ray, hit))
                && (fraction == 0 || second().throwsShadowAt(ray, hit));
    }

    @Override
    default Stream<Surface> parts() {
        return Stream.of(first(), second()).flatMap(Surface::parts);
    }

    @Override
    default boolean showsTime() {
        return first().showsTime() || second().showsTime();
    }

    @Override
    default boolean canTurn() {
        return first().canTurn() && second().canTurn();
    }

    @Override
    default Continuation continuation() {
        return first().continuation().orElsewhere(second().continuation());
    }

    @Override
    default boolean keepsPhase() {
        return first().keepsPhase() && second().keepsPhase();
    }
}
