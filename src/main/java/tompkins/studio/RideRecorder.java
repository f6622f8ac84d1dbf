package tompkins.studio;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3dc;
import tompkins.camera.Aim;
import tompkins.camera.Camera;

/** Takes note of a ride while it goes on: moments that follow each other become legs, as few as will do. */
public final class RideRecorder {

    private final Studio start;
    private final List<RideLeg> legs = new ArrayList<>();
    private Camera camera;

    /** A recorder of the ride that begins with a studio. */
    public RideRecorder(Studio start) {
        this.start = start;
        camera = start.camera();
    }

    /**
     * Takes note of a step.
     *
     * @param before the studio before the thrust, whose view may have been changed since the last step
     * @param thrust proper acceleration, to the right, up and forwards in the picture
     * @param properTime how long by a clock on board
     * @param seconds how long for those who see the film
     * @param after the studio after it
     */
    public void add(Studio before, Vector3dc thrust, double properTime, double seconds, Studio after) {
        Camera seen = before.camera();
        boolean turned = !seen.viewDirection().equals(camera.viewDirection());
        Aim turn = turned ? Aim.between(camera, seen) : Aim.NONE;
        RideLeg leg = new RideLeg(
                seconds,
                properTime,
                thrust,
                Math.toDegrees(turn.right()),
                Math.toDegrees(turn.up()),
                seen.horizontalAngleDegrees() / camera.horizontalAngleDegrees());
        int last = legs.size() - 1;
        if (last >= 0 && legs.get(last).goesOn(leg)) {
            legs.set(last, legs.get(last).with(leg));
        } else {
            legs.add(leg);
        }
        camera = after.camera();
    }

    /** Whether there was no step yet. */
    public boolean isEmpty() {
        return legs.isEmpty();
    }

    /** Seconds of the film so far. */
    public double seconds() {
        return legs.stream().mapToDouble(RideLeg::seconds).sum();
    }

    /** The studio with which the ride began, with the ride in it. */
    public Studio studio() {
        return start.withRide(legs);
    }
}
