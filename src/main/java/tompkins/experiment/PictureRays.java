package tompkins.experiment;

import org.joml.Vector3dc;
import tompkins.lesson.RayValue;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.studio.Studio;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;

/** The rays of one picture, each through the centre of the lens in the middle of the exposure, and what they tell. */
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

    /** The direction in which the camera looks at a place, a unit vector of the camera frame. */
    Vector3dc direction(Place place) {
        return plan.chiefDirection(place.x(plan.width()), place.y(plan.height()));
    }

    /**
     * What a ray tells.
     *
     * @throws InvalidPropertyException if it does not meet what could tell it
     */
    double read(Place place, RayValue value) {
        RayLife life = life(place);
        return switch (value) {
            case X -> seen(life).inScene(plan.studio().sceneFromCamera()).x();
            case Y -> seen(life).inScene(plan.studio().sceneFromCamera()).y();
            case Z -> seen(life).inScene(plan.studio().sceneFromCamera()).z();
            case TIME -> seen(life).inScene(plan.studio().sceneFromCamera()).time();
            case OWN_TIME -> seen(life).rest().event().time();
            case FREQUENCY_RATIO ->
                life.end() == null ? life.frequencyRatio() : life.end().rest().dopplerFactor();
            case BRIGHTNESS -> brightness(life.colour());
        };
    }

    /** The life of the ray of a place. */
    RayLife life(Place place) {
        return life(place, 0, 0);
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

    private static RayLife.Encounter seen(RayLife life) {
        if (life.end() == null) {
            throw new InvalidPropertyException("point", "where an object is seen", "one where none is");
        }
        return life.end();
    }

    /** The luminance of linear light, by the primaries of screens (ITU-R BT.709). */
    static double brightness(Colour colour) {
        return 0.2126 * colour.red() + 0.7152 * colour.green() + 0.0722 * colour.blue();
    }
}
