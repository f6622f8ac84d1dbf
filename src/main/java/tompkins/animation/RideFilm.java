package tompkins.animation;

import java.util.ArrayList;
import java.util.List;
import tompkins.image.AnimationFormat;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Require;
import tompkins.studio.ChallengeProgress;
import tompkins.studio.Ride;
import tompkins.studio.RideLeg;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;

/** The film of the ride that begins with a studio. */
public final class RideFilm implements FrameSequence {

    /** The longest film, in seconds. */
    public static final double LONGEST = 3600;

    private final List<RideLeg> legs;
    private final List<RideMoment> starts = new ArrayList<>();
    private final RideMoment end;
    private final double recorded;
    private final double seconds;
    private final int frameRate;

    /**
     * The film in the time in which the ride was recorded.
     *
     * @throws tompkins.property.InvalidPropertyException if the ride leads too far, gets too fast or takes too long
     */
    public RideFilm(Studio studio) {
        this(studio, Animation.FRAME_RATE);
    }

    /** The film with a number of photographs in a second; otherwise as {@link #RideFilm(Studio)}. */
    public RideFilm(Studio studio, int frameRate) {
        this(studio, studio.ride().stream().mapToDouble(RideLeg::seconds).sum(), frameRate);
    }

    /** The film in a time of its own, in seconds; otherwise as {@link #RideFilm(Studio, int)}. */
    public RideFilm(Studio studio, double seconds, int frameRate) {
        this.frameRate = Require.within("frameRate", frameRate, 1, AnimationFormat.FASTEST);
        legs = studio.ride();
        recorded = legs.stream().mapToDouble(RideLeg::seconds).sum();
        Require.within("ride", recorded, 0, LONGEST);
        this.seconds = Require.within("seconds", seconds, 0, LONGEST);
        RideMoment moment = RideMoment.start(studio);
        for (RideLeg leg : legs) {
            starts.add(moment);
            moment = moment.after(leg, leg.properTime());
        }
        end = moment;
    }

    /**
     * Checks that the legs of each ride of a studio meet its challenge, so that it can be met.
     *
     * @throws InvalidPropertyException if some do not; it names the ride
     */
    public static void requireChallenges(Studio studio) {
        for (int i = 0; i < studio.rides().size(); i++) {
            Ride ride = studio.rides().get(i);
            ChallengeProgress progress = ChallengeProgress.start(ride);
            if (!ride.challenge().isEmpty()) {
                progress = new RideFilm(ride.start(studio), AnimationFormat.FASTEST).after(progress);
                if (!progress.isMet()) {
                    throw new InvalidPropertyException(
                            "rides[" + i + "].legs",
                            "a flight that meets the challenge of the ride",
                            "one that misses goal " + (progress.reached() + 1) + " of "
                                    + ride.challenge().size());
                }
            }
        }
    }

    private ChallengeProgress after(ChallengeProgress start) {
        ChallengeProgress progress = start;
        RideMoment before = moment(0.0);
        for (int frame = 1; frame < frames(); frame++) {
            RideMoment now = moment(frame);
            progress = progress.after(before, now);
            before = now;
        }
        return progress;
    }

    /** How long it takes. */
    public double seconds() {
        return seconds;
    }

    /** The moment of the ride at a time of the film, in seconds; after its end, the last one. */
    public RideMoment moment(double time) {
        double left = seconds == 0 ? 0 : time / seconds * recorded;
        for (int i = 0; i < legs.size(); i++) {
            RideLeg leg = legs.get(i);
            if (left < leg.seconds()) {
                return starts.get(i).after(leg, left / leg.seconds() * leg.properTime());
            }
            left -= leg.seconds();
        }
        return end;
    }

    @Override
    public int frameRate() {
        return frameRate;
    }

    @Override
    public int frames() {
        return Math.max(1, 1 + (int) Math.round(seconds * frameRate));
    }

    /** The moment of a photograph. */
    public RideMoment moment(int frame) {
        return frame == frames() - 1 ? end : moment((double) frame / frameRate);
    }

    @Override
    public Studio studio(int frame) {
        return moment(frame).studio();
    }
}
