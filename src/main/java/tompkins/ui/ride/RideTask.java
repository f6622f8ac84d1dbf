package tompkins.ui.ride;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tompkins.studio.ChallengeProgress;
import tompkins.studio.Ride;
import tompkins.studio.RideGoal;
import tompkins.studio.RideMoment;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Texts;

/** What to try on a ride, how far that is done, and what became of the challenges that were tried before. */
final class RideTask {

    private static final String GAP = "; ";

    /** To be no faster means to stop. */
    private static final double NEARLY_AT_REST = 1.01;

    /**
     * What became of a challenge.
     *
     * @param text what was measured, what was asked for, and the outcome
     */
    record Verdict(boolean met, String text) {}

    private Ride ride = Ride.DEFAULT;
    private ChallengeProgress progress = ChallengeProgress.NONE;

    /** What was measured at the goals that were reached. */
    private final List<String> reached = new ArrayList<>();

    /** On the present challenge; null while it is open. */
    private Verdict verdict;

    /** The best verdict on each challenge of the scene. */
    private final Map<Ride, Verdict> verdicts = new HashMap<>();

    /** Another scene has other challenges. */
    void forget() {
        verdicts.clear();
        begin(Ride.DEFAULT);
    }

    /** Begins the task of a ride; none if it is the usual ride. */
    void begin(Ride begun) {
        ride = begun;
        restart();
    }

    /** The clocks begin again. */
    void restart() {
        progress = ChallengeProgress.start(ride);
        reached.clear();
        verdict = null;
    }

    /** Follows a step of the ride; true if there is a verdict now, and was none before. */
    boolean follow(RideMoment before, RideMoment now) {
        RideGoal next = next();
        if (next == null || verdict != null) {
            return false;
        }
        ChallengeProgress after = progress.after(before, now);
        if (after.isLost(now)) {
            settle(new Verdict(false, progress(now) + ": " + Texts.get("ride.missed")));
        } else if (after.reached() > progress.reached()) {
            reached.add(clocks(next, now));
            if (after.isMet()) {
                settle(new Verdict(true, place(next) + " " + String.join(GAP, reached) + ": " + Texts.get("ride.met")));
            }
        }
        progress = after;
        return verdict != null;
    }

    private void settle(Verdict found) {
        verdict = found;
        verdicts.merge(ride, found, (old, now) -> old.met && !now.met ? old : now);
    }

    /** The goal that comes next; null if there is none. */
    private RideGoal next() {
        return progress.reached() < progress.goals().size() ? progress.goals().get(progress.reached()) : null;
    }

    /** What to try; empty if nothing is said. */
    String text() {
        return ride.task();
    }

    /** On the present challenge; null while that is open. */
    Verdict verdict() {
        return verdict;
    }

    /** On the challenge of a ride, at best; null if it was not tried, or is open. */
    Verdict verdict(Ride tried) {
        return verdicts.get(tried);
    }

    /** How far it is to the next goal of the present challenge, and what the clocks say; empty without one. */
    String progress(RideMoment now) {
        RideGoal next = next();
        if (next == null) {
            return "";
        }
        double distance = next.position().distance(now.rider().event().position()) - next.within();
        String toGo = distance > 0 ? Texts.get("ride.toGo", Numbers.brief(distance, 3)) : place(next);
        return toGo + GAP + clocks(next, now);
    }

    /** What a place is called that is reached: a ride may lead home. */
    private String place(RideGoal goal) {
        return Texts.get(goal.position().equals(ride.position()) ? "ride.homeAgain" : "ride.there");
    }

    /** What is measured, and what is asked for: age, time, speed. */
    private static String clocks(RideGoal goal, RideMoment now) {
        double gamma = now.rider().gamma();
        List<String> words = new ArrayList<>();
        if (goal.younger() > 0) {
            words.add(words("ride.younger", now.sceneTime() - now.properTime(), goal.younger()));
        }
        if (goal.latest() < RideGoal.DEFAULT.latest()) {
            words.add(words("ride.aboard", now.properTime(), goal.latest()));
        }
        if (goal.leastGamma() > 1) {
            words.add(words("ride.fast", gamma, goal.leastGamma()));
        }
        if (goal.mostGamma() < NEARLY_AT_REST) {
            words.add(Texts.get(gamma <= goal.mostGamma() ? "ride.stopped" : "ride.stop"));
        } else if (goal.mostGamma() < RideGoal.DEFAULT.mostGamma()) {
            words.add(words("ride.slow", gamma, goal.mostGamma()));
        }
        return String.join(GAP, words);
    }

    private static String words(String key, double measured, double asked) {
        return Texts.get(key, String.format(Locale.ROOT, "%.1f", measured), Numbers.brief(asked));
    }
}
