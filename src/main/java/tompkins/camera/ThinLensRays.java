package tompkins.camera;

import java.util.Arrays;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.LensRay;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/** A {@link ThinLensCamera}, ready for one picture. */
final class ThinLensRays extends CameraRays {

    private final Vector3d right;
    private final Vector3d up;
    private final Vector3d forward;
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

    ThinLensRays(ThinLensCamera camera, int width, int height, SpaceTimeTransformation sceneFromCamera) {
        super(camera, width, height);
        CameraAxes axes = CameraAxes.of(camera.viewDirection(), camera.topDirection());
        right = new Vector3d(axes.right());
        up = new Vector3d(axes.up());
        forward = new Vector3d(axes.forward());
        centre = camera.stereo().lens(camera.position(), right);
        apertureRadius = camera.apertureRadius();
        shutter = camera.shutter();
        constantTime = shutter instanceof AperturePlaneShutter;
        // a pinhole needs its focus only where the shutter does
        boolean focused = camera.hasWideAperture() || shutter.needsFocus();
        focus = focused ? new FocusSurface(camera.surfaceInFocus()) : null;
        this.sceneFromCamera = sceneFromCamera;
        double halfWidth = Math.tan(Math.toRadians(camera.horizontalAngleDegrees()) / 2);
        double halfHeight = camera.verticalAngleDegrees() == 0
                ? halfWidth * height / width
                : Math.tan(Math.toRadians(camera.verticalAngleDegrees()) / 2);
        slopePerColumn = 2 * halfWidth / width;
        middleX = width / 2.0 - camera.stereo().middleSlope() / slopePerColumn;
        middleY = height / 2.0;
        slopePerRow = 2 * halfHeight / height;
        pixelAngle = Math.sqrt(slopePerColumn * slopePerRow);
    }

    @Override
    public Vector3d chiefDirection(double x, double y) {
        RayPacket rays = new RayPacket(1);
        aim(SamplePositions.single(x, y, 0, 0, SamplePositions.MIDDLE), rays);
        return new Vector3d(rays.dx[0], rays.dy[0], rays.dz[0]);
    }

    @Override
    public Vector2dc position(Vector3dc direction) {
        double ahead = direction.dot(forward);
        return ahead <= 0
                ? null
                : new Vector2d(
                        middleX + direction.dot(right) / ahead / slopePerColumn,
                        middleY - direction.dot(up) / ahead / slopePerRow);
    }

    @Override
    public double solidAngle(int column, int row) {
        double left = (column - middleX) * slopePerColumn;
        double top = (row - middleY) * slopePerRow;
        double right = left + slopePerColumn;
        double bottom = top + slopePerRow;
        return corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top);
    }

    /** The solid angle between the axis and a corner: the rectangle from (0, 0) to (x, y) at distance 1. */
    private static double corner(double x, double y) {
        return Math.atan2(x * y, Math.sqrt(1 + x * x + y * y));
    }

    @Override
    public Vector3dc lens(Vector3dc direction) {
        return centre;
    }

    @Override
    public LensRay chiefRay(Vector3dc direction) {
        return new LensRay(centre, centre, direction, inverseFocusDistance(direction, new RayCounts()), forward);
    }

    @Override
    void start(SamplePositions positions, RayPacket rays, RayCounts counts) {
        aim(positions, rays);
        if (constantTime && apertureRadius == 0) {
            startInPinhole(rays);
            return;
        }
        int made = 0;
        for (int i = 0; i < positions.count(); i++) {
            if (startOnLens(positions.lensX[i], positions.lensY[i], rays, i, counts)) {
                rays.move(i, made);
                made++;
            }
        }
        rays.keep(made);
    }

    /** Sets all directions to those through the centre of the lens, in short loops for several at once. */
    private void aim(SamplePositions positions, RayPacket rays) {
        int count = positions.count();
        // slopes and scales first, where the directions will be
        double[] toRight = rays.dx;
        double[] upwards = rays.dy;
        double[] scale = rays.dz;
        for (int i = 0; i < count; i++) {
            toRight[i] = (positions.x[i] - middleX) * slopePerColumn;
        }
        for (int i = 0; i < count; i++) {
            upwards[i] = (middleY - positions.y[i]) * slopePerRow;
        }
        for (int i = 0; i < count; i++) {
            scale[i] = 1 / Math.sqrt(1 + toRight[i] * toRight[i] + upwards[i] * upwards[i]);
        }
        for (int i = 0; i < count; i++) {
            double dx = (forward.x + toRight[i] * right.x + upwards[i] * up.x) * scale[i];
            double dy = (forward.y + toRight[i] * right.y + upwards[i] * up.y) * scale[i];
            double dz = (forward.z + toRight[i] * right.z + upwards[i] * up.z) * scale[i];
            rays.dx[i] = dx;
            rays.dy[i] = dy;
            rays.dz[i] = dz;
        }
        for (int i = 0; i < count; i++) {
            double cosine = rays.dx[i] * forward.x + rays.dy[i] * forward.y + rays.dz[i] * forward.z;
            rays.spread[i] = pixelAngle * cosine * cosine;
        }
    }

    private void startInPinhole(RayPacket rays) {
        Arrays.fill(rays.x, 0, rays.count(), centre.x());
        Arrays.fill(rays.y, 0, rays.count(), centre.y());
        Arrays.fill(rays.z, 0, rays.count(), centre.z());
        Arrays.fill(rays.time, 0, rays.count(), shutter.openingTime());
    }

    /** Lets a ray that was aimed start at a position on the lens; false if it never crosses the shutter. */
    private boolean startOnLens(double lensX, double lensY, RayPacket rays, int index, RayCounts counts) {
        Vector3d chief = new Vector3d(rays.dx[index], rays.dy[index], rays.dz[index]);
        double inverseFocusDistance = inverseFocusDistance(chief, counts);
        Vector3d pupilPoint = offset(lensX, lensY).add(centre);
        LensRay ray = new LensRay(centre, pupilPoint, chief, inverseFocusDistance, forward);
        double time = constantTime ? shutter.openingTime() : shutter.transmissionTime(ray, sceneFromCamera);
        if (!Double.isFinite(time)) {
            counts.withoutShutter++;
            return false;
        }
        rays.x[index] = pupilPoint.x;
        rays.y[index] = pupilPoint.y;
        rays.z[index] = pupilPoint.z;
        rays.time[index] = time;
        if (apertureRadius > 0) {
            Vector3d direction = ray.towardsFocus().normalize();
            rays.dx[index] = direction.x;
            rays.dy[index] = direction.y;
            rays.dz[index] = direction.z;
        }
        return true;
    }

    private double inverseFocusDistance(Vector3dc chief, RayCounts counts) {
        double inverse = focus == null ? 0 : focus.inverseDistance(centre, chief);
        if (Double.isNaN(inverse)) {
            counts.withoutFocus++;
            return 0;
        }
        return inverse;
    }

    private Vector3d offset(double lensX, double lensY) {
        double toRight = apertureRadius * lensX;
        double upwards = apertureRadius * lensY;
        return new Vector3d(
                toRight * right.x + upwards * up.x,
                toRight * right.y + upwards * up.y,
                toRight * right.z + upwards * up.z);
    }
}
