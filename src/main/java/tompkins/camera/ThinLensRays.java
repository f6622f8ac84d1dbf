package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.LensRay;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/** A {@link ThinLensCamera}, ready for one picture. */
final class ThinLensRays implements CameraRays {

    private final CameraAxes axes;
    private final Vector3dc centre;
    private final double apertureRadius;
    private final Shutter shutter;
    private final boolean constantTime;
    private final FocusSurface focus;
    private final SpaceTimeTransformation sceneFromCamera;
    private final double halfWidth;
    private final double halfHeight;
    private final double pixelsToRight;
    private final double pixelsDown;
    private final double pixelAngle;

    ThinLensRays(ThinLensCamera camera, int width, int height, SpaceTimeTransformation sceneFromCamera) {
        axes = CameraAxes.of(camera.viewDirection(), camera.topDirection());
        centre = camera.position();
        apertureRadius = camera.apertureRadius();
        shutter = camera.shutter();
        constantTime = shutter instanceof AperturePlaneShutter;
        // a pinhole needs its focus only where the shutter does
        boolean focused = camera.hasWideLens() || shutter.needsFocus();
        focus = focused ? new FocusSurface(camera.focus()) : null;
        this.sceneFromCamera = sceneFromCamera;
        halfWidth = Math.tan(Math.toRadians(camera.horizontalAngleDegrees()) / 2);
        halfHeight = camera.verticalAngleDegrees() == 0
                ? halfWidth * height / width
                : Math.tan(Math.toRadians(camera.verticalAngleDegrees()) / 2);
        pixelsToRight = width;
        pixelsDown = height;
        pixelAngle = 2 * Math.sqrt(halfWidth / width * halfHeight / height);
    }

    @Override
    public Vector3d chiefDirection(double x, double y) {
        double right = (2 * x / pixelsToRight - 1) * halfWidth;
        double up = (1 - 2 * y / pixelsDown) * halfHeight;
        double length = Math.sqrt(1 + right * right + up * up);
        return new Vector3d(
                (axes.forward().x() + right * axes.right().x() + up * axes.up().x()) / length,
                (axes.forward().y() + right * axes.right().y() + up * axes.up().y()) / length,
                (axes.forward().z() + right * axes.right().z() + up * axes.up().z()) / length);
    }

    @Override
    public Ray ray(double x, double y, double lensX, double lensY, RayCounts counts) {
        Vector3d chief = chiefDirection(x, y);
        double cosine = chief.dot(axes.forward());
        double spread = pixelAngle * cosine * cosine;
        double inverseFocusDistance = focus == null ? 0 : inverseFocusDistance(chief, counts);
        Vector3d offset = offset(lensX, lensY);
        Vector3d pupilPoint = offset.add(centre, new Vector3d());
        double time = constantTime
                ? shutter.openingTime()
                : shutter.transmissionTime(
                        new LensRay(centre, pupilPoint, chief, inverseFocusDistance, axes.forward()), sceneFromCamera);
        if (!Double.isFinite(time)) {
            counts.withoutShutter++;
            return null;
        }
        // light that comes parallel to the chief ray meets in the detector point; the rest of the lens's power
        // makes the ray come from the point in focus
        Vector3d direction = apertureRadius == 0
                ? chief
                : ThinLens.bend(chief, axes.forward(), offset, inverseFocusDistance / cosine)
                        .normalize();
        return Ray.fromCamera(
                pupilPoint.x, pupilPoint.y, pupilPoint.z, direction.x, direction.y, direction.z, time, spread);
    }

    private double inverseFocusDistance(Vector3dc chief, RayCounts counts) {
        double inverse = focus.inverseDistance(centre, chief);
        if (Double.isNaN(inverse)) {
            counts.withoutFocus++;
            return 0;
        }
        return inverse;
    }

    private Vector3d offset(double lensX, double lensY) {
        double right = apertureRadius * lensX;
        double up = apertureRadius * lensY;
        return new Vector3d(
                right * axes.right().x() + up * axes.up().x(),
                right * axes.right().y() + up * axes.up().y(),
                right * axes.right().z() + up * axes.up().z());
    }
}
