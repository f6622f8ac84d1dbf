package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.math.Vectors;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.surface.ColouredSurface;

/** A camera with an ideal thin lens, or with a pinhole if the aperture radius is 0. */
@Meaning("A camera with an ideal thin lens, or with a pinhole if the aperture radius is 0")
public record ThinLensCamera(
        @Meaning(value = "Centre of the lens, in the camera frame", unit = "length")
        Vector3dc position,

        @Meaning("Direction in which the camera looks, of any length")
        Vector3dc viewDirection,

        @Meaning("Direction that points up in the picture, as far as the view direction allows")
        Vector3dc topDirection,

        @Meaning(value = "Angle between the left and the right edge of the picture, below 180", unit = "degrees")
        double horizontalAngleDegrees,

        @Meaning(
                value = "Angle between the upper and the lower edge, below 180; 0 gives square pixels",
                unit = "degrees")
        double verticalAngleDegrees,

        @Meaning(value = "Radius of the aperture; 0 is a pinhole", unit = "length")
        double apertureRadius,

        @Meaning(
                value = "Distance in focus: the plane across the view there is sharp; with 0 it is the surface of"
                        + " focus. A number as focus means the same",
                unit = "length")
        double focusDistance,

        @Meaning("The object on whose surface the camera is focused, at rest in the camera frame, if there is no"
                + " focusDistance")
        SceneObject focus,

        @Meaning(value = "Exposure compensation, -100 to 100; 1 stop doubles the light", unit = "stops")
        double exposureStops,

        @Meaning("Where the shutter is and when it opens") Shutter shutter,

        @Meaning(
                value = "Time for which the shutter stays open, 0 to 1e50; the picture is the mean over it",
                unit = "time")
        double exposureTime,

        @Meaning("How the shutter runs across the picture") RollingShutter rollingShutter,

        @Meaning("The pictures of two eyes, for a view in depth")
        Stereo stereo)
        implements Camera {

    /** A pinhole camera as in Dr TIM for the paper: 20 degrees wide, focused on the plane z = 10. */
    public static final ThinLensCamera DEFAULT = new ThinLensCamera(
            new Vector3d(),
            new Vector3d(0, 0, 1),
            new Vector3d(0, 1, 0),
            20,
            0,
            0,
            0,
            new Plane("focus", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT),
            0,
            AperturePlaneShutter.DEFAULT,
            0,
            RollingShutter.DEFAULT,
            Stereo.DEFAULT);

    /** Checks all values; a plane in focus must not pass through the lens centre. */
    public ThinLensCamera {
        position = Require.position("position", position);
        viewDirection = Require.direction("viewDirection", viewDirection);
        topDirection = CameraAxes.requireTop(topDirection, viewDirection);
        Require.between("horizontalAngleDegrees", horizontalAngleDegrees, 0, 180);
        Require.notNegativeBelow("verticalAngleDegrees", verticalAngleDegrees, 180);
        Require.notNegative("apertureRadius", apertureRadius);
        Require.duration("focusDistance", focusDistance);
        if (focusDistance != 0 && !Descriptions.areEqual(focus, DEFAULT.focus)) {
            throw new InvalidPropertyException(
                    "focusDistance", "0 or left out beside a focus: only one of both counts", focusDistance);
        }
        SceneObject.requireAtRest("focus", focus);
        for (Vector3dc lens : stereo.lenses(
                position, CameraAxes.of(viewDirection, topDirection).right())) {
            if (focus instanceof Plane plane
                    && plane.point().sub(lens, new Vector3d()).dot(plane.normal()) == 0) {
                double distance = Vectors.unit(viewDirection).dot(plane.point().sub(position, new Vector3d()));
                throw new InvalidPropertyException(
                        "focus",
                        "a surface that does not pass through the lens centre " + Require.text(lens),
                        "a plane with the normal " + Require.text(plane.normal())
                                + (distance > 0
                                        ? "; for the plane across the view write the distance "
                                                + NumberText.of(distance) + " alone"
                                        : ""));
            }
        }
        if (focus.primitiveCount() > SceneObject.MOST_PRIMITIVES) {
            throw new InvalidPropertyException(
                    "focus",
                    "a surface of at most " + NumberText.of(SceneObject.MOST_PRIMITIVES) + " primitives",
                    NumberText.of(focus.primitiveCount()));
        }
        // refuses sizes that cannot be worked with
        FocusSurface.primitives(focus);
        Require.within("exposureStops", exposureStops, -100.0, 100.0);
        Require.duration("exposureTime", exposureTime);
    }

    /** What is sharp: the plane at the distance in focus if there is one, or else the surface of the focus. */
    public SceneObject surfaceInFocus() {
        return focusDistance == 0 ? focus : planeAcross(focusDistance);
    }

    /** The plane across the view at a distance, which is below 0 behind the lens. */
    Plane planeAcross(double distance) {
        Vector3d view = Vectors.unit(viewDirection);
        Vector3d point = new Vector3d(view).mul(distance).add(position);
        return new Plane("focus", point, view, ColouredSurface.DEFAULT);
    }

    @Override
    public boolean hasWideAperture() {
        return apertureRadius > 0;
    }

    @Override
    public CameraRays rays(int width, int height, SpaceTimeTransformation sceneFromCamera) {
        return new ThinLensRays(this, width, height, sceneFromCamera);
    }
}
