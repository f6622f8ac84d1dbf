package tompkins.ui.ride;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.animation.RideFilm;

/** What a {@link RidePilot} does. */
sealed interface RideState {

    /**
     * Time stands still.
     *
     * @param shown whether a recorded ride was shown last, and none flown
     */
    record Idle(boolean shown) implements RideState {}

    /**
     * Thrust and turns lead the ride.
     *
     * @param wish where thrust is wished: each component from -1 to 1, to the right, up and forwards
     * @param brakes whether it brakes until the camera is at rest in the scene
     * @param records whether the ride will be kept in the scene
     */
    record Flying(Vector3dc wish, boolean brakes, boolean records) implements RideState {

        /** Without thrust. */
        static Flying coasting(boolean records) {
            return new Flying(new Vector3d(), false, records);
        }

        Flying steered(Vector3dc newWish, boolean newBrakes) {
            return new Flying(new Vector3d(newWish), newBrakes, records);
        }
    }

    /**
     * A recorded ride is shown.
     *
     * @param seconds how much of the film was shown
     */
    record Replaying(RideFilm film, double seconds) implements RideState {

        Replaying after(double more) {
            return new Replaying(film, seconds + more);
        }

        boolean isOver() {
            return seconds >= film.seconds();
        }
    }
}
