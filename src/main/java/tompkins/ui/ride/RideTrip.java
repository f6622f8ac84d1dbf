package tompkins.ui.ride;

import tompkins.studio.RideMoment;
import tompkins.studio.RideRecorder;
import tompkins.studio.Studio;

/**
 * How far a ride has come.
 *
 * @param start where it began that is flown, or shown
 * @param moment where it is
 * @param recorder takes note of what is flown by hand
 */
record RideTrip(Studio start, RideMoment moment, RideRecorder recorder) {

    static RideTrip from(Studio start, RideMoment moment) {
        return new RideTrip(start, moment, new RideRecorder(moment.studio()));
    }

    RideTrip at(RideMoment next) {
        return new RideTrip(start, next, recorder);
    }
}
