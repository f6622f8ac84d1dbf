package tompkins.camera;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.LensRay;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpaceTimeTransformation;

/**
 * A pinhole camera that sees in all directions: columns are even steps of longitude, rows even steps of latitude. Each
 * pixel has a detector of its own straight behind the pinhole, and is focused at one distance.
 */
@Meaning("A pinhole camera that sees all around: columns are steps of longitude, rows steps of latitude")
public record PanoramicCamera(
        @Meaning(value = "The pinhole, in the camera frame", unit = "length")
        Vector3dc position,

        @Meaning("Direction of the middle of the picture, of any length")
        Vector3dc viewDirection,

        @Meaning("Direction that points up in the picture, as far as the view direction allows")
        Vector3dc topDirection,

        @Meaning(value = "Longitudes in the picture, at most 360", unit = "degrees")
        double horizontalAngleDegrees,

        @Meaning(value = "Latitudes in the picture, at most 180", unit = "degrees")
        double verticalAngleDegrees,

        @Meaning(value = "Distance in focus, for shutters that depend on it", unit = "length")
        double focusDistance,

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

    /** The whole sky. */
    public static final PanoramicCamera DEFAULT = new PanoramicCamera(
            new Vector3d(),
            new Vector3d(0, 0, 1),
            new Vector3d(0, 1, 0),
            360,
            180,
            10,
            0,
            AperturePlaneShutter.DEFAULT,
            0,
            RollingShutter.DEFAULT,
            Stereo.DEFAULT);

    /** Checks all values. */
    public PanoramicCamera {
        position = Require.position("position", position);
        viewDirection = Require.direction("viewDirection", viewDirection);
        topDirection = CameraAxes.requireTop(topDirection, viewDirection);
        Require.positive("horizontalAngleDegrees", horizontalAngleDegrees, 360);
        Require.positive("verticalAngleDegrees", verticalAngleDegrees, 180);
        Require.distance("focusDistance", focusDistance);
        Require.within("exposureStops", exposureStops, -100.0, 100.0);
        Require.duration("exposureTime", exposureTime);
        if (!accepts(shutter.getClass(), stereo)) {
            throw new InvalidPropertyException(
                    "shutter",
                    "AperturePlaneShutter, because the eyes of a panorama turn with its columns and share no detector or"
                            + " focus",
                    shutter.getClass().getSimpleName());
        }
    }

    @Override
    public boolean accepts(Class<?> type) {
        return accepts(type, stereo);
    }

    /** Eyes that turn have no common detector or focus, whose shutter another model could be. */
    private static boolean accepts(Class<?> type, Stereo stereo) {
        return stereo.layout() == StereoLayout.NONE || type == AperturePlaneShutter.class;
    }

    @Override
    public boolean hasWideAperture() {
        return false;
    }

    @Override
    public CameraRays rays(int width, int height, SpaceTimeTransformation sceneFromCamera) {
        return new Rays(this, width, height, sceneFromCamera);
    }

    private static final class Rays extends CameraRays {

        private final PanoramicCamera camera;
        private final CameraAxes axes;
        private final SpaceTimeTransformation sceneFromCamera;
        private final double longitudePerPixel;
        private final double latitudePerPixel;

        /** The longitude that the eye shows in the middle of its picture. */
        private final double turn;

        private final double pictureMiddle;

        /** The column of longitude 0. */
        private final double middleX;

        private final double middleY;

        Rays(PanoramicCamera camera, int width, int height, SpaceTimeTransformation sceneFromCamera) {
            super(camera, width, height);
            this.camera = camera;
            this.sceneFromCamera = sceneFromCamera;
            axes = CameraAxes.of(camera.viewDirection, camera.topDirection);
            longitudePerPixel = Math.toRadians(camera.horizontalAngleDegrees) / width;
            latitudePerPixel = Math.toRadians(camera.verticalAngleDegrees) / height;
            turn = Math.asin(camera.stereo().middleSlope());
            pictureMiddle = width / 2.0;
            middleX = pictureMiddle - turn / longitudePerPixel;
            middleY = height / 2.0;
        }

        @Override
        public LensRay chiefRay(Vector3dc direction) {
            Vector3dc lens = lens(direction);
            return new LensRay(lens, lens, direction, 1 / camera.focusDistance, direction);
        }

        @Override
        public Vector3dc lens(Vector3dc direction) {
            if (camera.stereo.layout().side() == 0) {
                return camera.position;
            }
            double longitude = Math.atan2(direction.dot(axes.right()), direction.dot(axes.forward()));
            Vector3d right = new Vector3d(axes.right())
                    .mul(Math.cos(longitude))
                    .add(new Vector3d(axes.forward()).mul(-Math.sin(longitude)));
            return camera.stereo.lens(camera.position, right);
        }

        @Override
        public Vector2dc position(Vector3dc direction) {
            double ahead = direction.dot(axes.forward());
            double right = direction.dot(axes.right());
            double latitude = Math.atan2(direction.dot(axes.up()), Math.hypot(ahead, right));
            double fromMiddle = Math.IEEEremainder(Math.atan2(right, ahead) - turn, 2 * Math.PI);
            return new Vector2d(pictureMiddle + fromMiddle / longitudePerPixel, middleY - latitude / latitudePerPixel);
        }

        @Override
        public List<Vector2dc> positions(Vector3dc direction) {
            Vector2dc position = position(direction);
            double around = 2 * Math.PI / longitudePerPixel;
            double half = Math.PI / latitudePerPixel;
            List<Vector2dc> positions = new ArrayList<>();
            for (double turn : new double[] {-around, 0, around}) {
                positions.add(new Vector2d(position.x() + turn, position.y()));
            }
            // beyond a pole the picture goes on at the opposite longitude
            for (double turn : new double[] {-around / 2, around / 2}) {
                positions.add(new Vector2d(position.x() + turn, 2 * middleY - half - position.y()));
                positions.add(new Vector2d(position.x() + turn, 2 * middleY + half - position.y()));
            }
            return positions;
        }

        @Override
        public double solidAngle(int column, int row) {
            double latitude = (middleY - row - 0.5) * latitudePerPixel;
            return 2 * longitudePerPixel * Math.cos(latitude) * Math.sin(latitudePerPixel / 2);
        }

        @Override
        public Vector3d chiefDirection(double x, double y) {
            double longitude = (x - middleX) * longitudePerPixel;
            double latitude = (middleY - y) * latitudePerPixel;
            double level = Math.cos(latitude);
            return new Vector3d(axes.forward())
                    .mul(level * Math.cos(longitude))
                    .add(new Vector3d(axes.right()).mul(level * Math.sin(longitude)))
                    .add(new Vector3d(axes.up()).mul(Math.sin(latitude)));
        }

        @Override
        void start(SamplePositions positions, RayPacket rays, RayCounts counts) {
            int made = 0;
            for (int i = 0; i < positions.count(); i++) {
                Vector3d chief = chiefDirection(positions.x[i], positions.y[i]);
                LensRay ray = chiefRay(chief);
                double time = camera.shutter.transmissionTime(ray, sceneFromCamera);
                if (!Double.isFinite(time)) {
                    counts.withoutShutter++;
                    continue;
                }
                rays.x[i] = ray.centre().x();
                rays.y[i] = ray.centre().y();
                rays.z[i] = ray.centre().z();
                rays.dx[i] = chief.x;
                rays.dy[i] = chief.y;
                rays.dz[i] = chief.z;
                rays.time[i] = time;
                double level = Math.cos((middleY - positions.y[i]) * latitudePerPixel);
                rays.spread[i] = Math.max(latitudePerPixel, longitudePerPixel * level);
                rays.move(i, made);
                made++;
            }
            rays.keep(made);
        }
    }
}
