package tompkins.camera;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.RayBlock;
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
    private final double middleX;
    private final double middleY;
    private final double slopePerColumn;
    private final double slopePerRow;
    private final double pixelAngle;

    // the axes as plain numbers, for every ray asks for them
    private final double rightX;
    private final double rightY;
    private final double rightZ;
    private final double upX;
    private final double upY;
    private final double upZ;
    private final double forwardX;
    private final double forwardY;
    private final double forwardZ;

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
        double halfWidth = Math.tan(Math.toRadians(camera.horizontalAngleDegrees()) / 2);
        double halfHeight = camera.verticalAngleDegrees() == 0
                ? halfWidth * height / width
                : Math.tan(Math.toRadians(camera.verticalAngleDegrees()) / 2);
        middleX = width / 2.0;
        middleY = height / 2.0;
        slopePerColumn = 2 * halfWidth / width;
        slopePerRow = 2 * halfHeight / height;
        pixelAngle = Math.sqrt(slopePerColumn * slopePerRow);
        rightX = axes.right().x();
        rightY = axes.right().y();
        rightZ = axes.right().z();
        upX = axes.up().x();
        upY = axes.up().y();
        upZ = axes.up().z();
        forwardX = axes.forward().x();
        forwardY = axes.forward().y();
        forwardZ = axes.forward().z();
    }

    @Override
    public Vector3d chiefDirection(double x, double y) {
        double right = (x - middleX) * slopePerColumn;
        double up = (middleY - y) * slopePerRow;
        double scale = 1 / Math.sqrt(1 + right * right + up * up);
        return new Vector3d(
                (forwardX + right * rightX + up * upX) * scale,
                (forwardY + right * rightY + up * upY) * scale,
                (forwardZ + right * rightZ + up * upZ) * scale);
    }

    @Override
    public boolean add(double x, double y, double lensX, double lensY, RayBlock rays, RayCounts counts) {
        Vector3d chief = chiefDirection(x, y);
        double cosine = chief.x * forwardX + chief.y * forwardY + chief.z * forwardZ;
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
            return false;
        }
        // light that comes parallel to the chief ray meets in the detector point; the rest of the lens's power
        // makes the ray come from the point in focus
        Vector3d direction = apertureRadius == 0
                ? chief
                : ThinLens.bend(chief, axes.forward(), offset, inverseFocusDistance / cosine)
                        .normalize();
        rays.add(pupilPoint.x, pupilPoint.y, pupilPoint.z, direction.x, direction.y, direction.z, time, spread);
        return true;
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
        return new Vector3d(right * rightX + up * upX, right * rightY + up * upY, right * rightZ + up * upZ);
    }
}
