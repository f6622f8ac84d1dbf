package tompkins.studio;

import java.util.List;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.camera.FieldOfView;
import tompkins.math.Vectors;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;
import tompkins.spacetime.Event;
import tompkins.spacetime.Rider;
import tompkins.spacetime.Velocity;

/**
 * A moment of a ride with the camera: an ordinary studio, photographed from the momentary rest frame of the rider. The
 * events of its photographs at the centre of the lens lie on one worldline, and the camera turns no more than a
 * gyroscope on board does, so that the picture never jumps.
 *
 * <p>A ride obeys special relativity, whatever law the picture follows.
 *
 * @param studio the studio at this moment
 * @param rider where, when and how fast the camera is in the scene frame
 * @param properTime time on board since the beginning
 * @param sceneTime time of the scene since the beginning
 */
public record RideMoment(Studio studio, Rider rider, double properTime, double sceneTime) {

    /** The beginning of a ride, from where the camera of a studio is. */
    public static RideMoment start(Studio studio) {
        Rider rider = new Rider(LensEvent.inScene(studio), studio.velocity());
        return new RideMoment(studio.withRide(List.of()), rider, 0, 0);
    }

    /**
     * A moment of the ride that a studio holds.
     *
     * @param properTime time on board since its beginning
     * @throws InvalidPropertyException if the ride is over by then, gets too fast, or leads too far
     */
    public static RideMoment onRide(Studio studio, double properTime) {
        double whole = studio.ride().stream().mapToDouble(RideLeg::properTime).sum();
        Require.within("properTime", properTime, 0, whole);
        RideMoment moment = start(studio);
        double left = properTime;
        for (RideLeg leg : studio.ride()) {
            moment = moment.after(leg, Math.min(left, leg.properTime()));
            left -= leg.properTime();
            if (left <= 0) {
                break;
            }
        }
        return moment;
    }

    /** The same moment with another studio, such as one with another view, whose camera is at the same event. */
    public RideMoment with(Studio other) {
        return new RideMoment(other.withRide(List.of()), rider, properTime, sceneTime);
    }

    /** Whether the camera of a studio still has the place, the velocity and the opening time of this moment. */
    public boolean isOf(Studio other) {
        Camera before = studio.camera();
        Camera now = other.camera();
        return other.velocity().equals(studio.velocity())
                && other.transformation() == studio.transformation()
                && now.position().equals(before.position())
                && now.shutter().getClass() == before.shutter().getClass()
                && now.shutter().openingTime() == before.shutter().openingTime();
    }

    /** What a camera at rest in the scene sees at this event, with the axes that the moving one has in its frame. */
    public Studio atRest() {
        return LensEvent.moved(studio, rider.event(), Velocity.REST, new Quaterniond());
    }

    /**
     * A later moment, after constant thrust.
     *
     * @param thrust proper acceleration, to the right, up and forwards in the picture
     * @param time how long, by a clock on board
     * @throws InvalidPropertyException if the camera gets too fast, or too far away
     */
    public RideMoment after(Vector3dc thrust, double time) {
        return at(rider.after(inCamera(thrust), time), time);
    }

    /** The thrust that brakes now, to the right, up and forwards in the picture; 0 at rest. */
    public Vector3d brake(double strength) {
        Vector3d inCamera = rider.brake(strength);
        Camera camera = studio.camera();
        return new Vector3d(
                inCamera.dot(camera.rightDirection()),
                inCamera.dot(camera.upDirection()),
                inCamera.dot(Vectors.unit(camera.viewDirection())));
    }

    /** The moment after the first part of a leg, whose length is a time by a clock on board. */
    public RideMoment after(RideLeg leg, double properPart) {
        return turned(leg).after(leg.acceleration(), properPart);
    }

    private RideMoment turned(RideLeg leg) {
        Camera camera = studio.camera();
        if (leg.zoom() != 1) {
            camera = FieldOfView.zoomed(camera, leg.zoom());
        }
        if (leg.turnRightDegrees() != 0 || leg.turnUpDegrees() != 0) {
            camera = new Aim(Math.toRadians(leg.turnRightDegrees()), Math.toRadians(leg.turnUpDegrees())).turn(camera);
        }
        return camera == studio.camera() ? this : with(studio.withCamera(camera));
    }

    private Vector3d inCamera(Vector3dc thrust) {
        Camera camera = studio.camera();
        return new Vector3d(camera.rightDirection())
                .mul(thrust.x())
                .fma(thrust.y(), camera.upDirection())
                .fma(thrust.z(), Vectors.unit(camera.viewDirection()));
    }

    private RideMoment at(Rider.Step step, double time) {
        if (time == 0) {
            return this;
        }
        Event event = step.rider().event();
        // without thrust the velocity stays as it was written
        Velocity velocity = step.rider().proper().equals(rider.proper())
                ? studio.velocity()
                : step.rider().velocity();
        Studio moved = LensEvent.moved(studio, event, velocity, step.turn());
        double sceneStep = event.time() - rider.event().time();
        return new RideMoment(moved, step.rider(), properTime + time, sceneTime + sceneStep);
    }
}
