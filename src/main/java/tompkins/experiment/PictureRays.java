package tompkins.experiment;

import tompkins.lesson.RayValue;
import tompkins.measure.Sighting;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.spacetime.Event;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/**
 * The rays of one picture, each through the centre of the lens in the middle of the exposure, and what is read from
 * them.
 */
final class PictureRays {

    private final RenderPlan plan;

    /**
     * The rays of a studio's picture.
     *
     * @throws InvalidPropertyException if an object is too large or too small to work with
     */
    PictureRays(Studio studio) {
        plan = RenderPlan.of(studio);
    }

    /** The plan of the picture. */
    RenderPlan plan() {
        return plan;
    }

    /**
     * What a place shows.
     *
     * @throws InvalidPropertyException if no ray comes through the shutter there
     */
    Sighting at(Place place) {
        return new Sighting(plan.studio(), place.x(plan.width()), place.y(plan.height()), life(place, 0, 0));
    }

    /**
     * The life of a ray.
     *
     * @param lensX place on the lens in units of its radius
     * @param lensY place on the lens in units of its radius
     * @throws InvalidPropertyException if the ray never crosses the shutter
     */
    RayLife life(Place place, double lensX, double lensY) {
        RayLife life = RayLife.of(plan, place.x(plan.width()), place.y(plan.height()), lensX, lensY);
        if (life == null) {
            throw new InvalidPropertyException("point", "where a ray crosses the shutter", place.text());
        }
        return life;
    }

    /**
     * What is read from a ray.
     *
     * @throws InvalidPropertyException if it meets nothing from which this could be read
     */
    double read(Place place, RayValue value) {
        Sighting sighting = at(place);
        return switch (value) {
            case X -> emission(sighting).x();
            case Y -> emission(sighting).y();
            case Z -> emission(sighting).z();
            case TIME -> emission(sighting).time();
            case OWN_TIME -> seen(sighting).rest().event().time();
            case FREQUENCY_RATIO ->
                sighting.hit() == null
                        ? sighting.dopplerFactor()
                        : sighting.hit().rest().dopplerFactor();
            case BRIGHTNESS -> {
                Colour colour = sighting.life().colour();
                yield Colour.luminance(colour.red(), colour.green(), colour.blue());
            }
        };
    }

    private static RayLife.Encounter seen(Sighting sighting) {
        if (sighting.hit() == null) {
            throw new InvalidPropertyException("point", "where an object is seen", "one where none is");
        }
        return sighting.hit();
    }

    private static Event emission(Sighting sighting) {
        return seen(sighting).inScene(sighting.studio().sceneFromCamera());
    }
}
