package tompkins.studio;

import java.util.List;

/**
 * How far a ride has come with its challenge.
 *
 * @param goals what is to be reached, one after the other; empty if nothing is
 * @param reached how many of them are
 */
public record ChallengeProgress(List<RideGoal> goals, int reached) {

    /** No challenge. */
    public static final ChallengeProgress NONE = new ChallengeProgress(List.of(), 0);

    /** At the start of a ride. */
    public static ChallengeProgress start(Ride ride) {
        return new ChallengeProgress(ride.challenge(), 0);
    }

    /** After a step of the ride. */
    public ChallengeProgress after(RideMoment before, RideMoment now) {
        int next = reached;
        while (next < goals.size() && goals.get(next).isReached(before, now)) {
            next++;
        }
        return next == reached ? this : new ChallengeProgress(goals, next);
    }

    /** Whether the challenge is met. */
    public boolean isMet() {
        return !goals.isEmpty() && reached == goals.size();
    }

    /** Whether the clock on board has passed the time of the next goal. */
    public boolean isLost(RideMoment now) {
        return reached < goals.size() && now.properTime() > goals.get(reached).latest();
    }
}
