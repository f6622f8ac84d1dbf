package tompkins.ui.ride;

import tompkins.studio.ChallengeProgress;
import tompkins.studio.Ride;
import tompkins.studio.RideMoment;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/** What to try on a ride, and how far that is done. */
final class RideTask {

    private Ride ride;
    private ChallengeProgress progress = ChallengeProgress.NONE;
    private String news = "";

    /** Begins the task of a ride. */
    void begin(Ride begun) {
        ride = begun;
        progress = ChallengeProgress.start(begun);
        news = "";
    }

    /** There is nothing to try from now on. */
    void clear() {
        begin(Ride.DEFAULT);
    }

    /** The clocks begin again, on the same ride or on another one, of which nothing is known. */
    void restart(boolean same) {
        if (!same) {
            clear();
        }
        progress = new ChallengeProgress(progress.goals(), 0);
        news = "";
    }

    /** Follows a step of the ride; true if there is something new to say. */
    boolean follow(RideMoment before, RideMoment now) {
        progress = progress.after(before, now);
        if (news.isEmpty() && progress.isMet()) {
            news = told("ride.done", now);
        } else if (news.isEmpty() && progress.isLost(now)) {
            news = told("ride.late", now);
        } else {
            return false;
        }
        return true;
    }

    private static String told(String key, RideMoment now) {
        return Texts.get(key, Numbers.brief(now.properTime()), Numbers.brief(now.sceneTime()));
    }

    /** The ride that is flown, one of the scene or another; null before the first. */
    Ride ride() {
        return ride;
    }

    /** What to try; empty if nothing is said. */
    String text() {
        return ride == null ? "" : ride.task();
    }

    /** That the challenge is met, or can no more be; empty before. */
    String news() {
        return news;
    }
}
