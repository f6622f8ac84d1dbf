package tompkins.animation;

import tompkins.image.AnimationFormat;
import tompkins.property.NumberText;
import tompkins.property.Require;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;

/**
 * A number of the studio that runs from one value to another.
 *
 * @param number the number
 * @param from value at the beginning
 * @param to value at the end, or in the middle if the animation runs there and back
 * @param seconds how long it takes, from {@link #SHORTEST} to {@link #LONGEST}
 * @param course how it runs
 * @param frameRate pictures a second in a file, from 1 to {@link AnimationFormat#FASTEST}
 */
public record Animation(StudioNumber number, double from, double to, double seconds, Course course, int frameRate) {

    /** The fewest seconds that an animation takes. */
    public static final double SHORTEST = 0.1;

    /** The most seconds that an animation takes. */
    public static final double LONGEST = 600;

    /** The number of digits in which values differ from the ends. */
    private static final int DIGITS = 9;

    /** The most digits that a double has. */
    private static final int MOST_DIGITS = 17;

    /** The usual number of pictures a second in a file. */
    public static final int FRAME_RATE = 25;

    /** Checks the seconds and the frame rate. */
    public Animation {
        Require.within("seconds", seconds, SHORTEST, LONGEST);
        Require.within("frameRate", frameRate, 1, AnimationFormat.FASTEST);
    }

    /** An animation with the usual number of pictures a second. */
    public Animation(StudioNumber number, double from, double to, double seconds, Course course) {
        this(number, from, to, seconds, course, FRAME_RATE);
    }

    /** The same animation with another number of pictures a second. */
    public Animation withFrameRate(int picturesASecond) {
        return new Animation(number, from, to, seconds, course, picturesASecond);
    }

    /** How an animation runs. */
    public enum Course {
        /** From the first value to the last. */
        FORWARDS,
        /** From the last value to the first. */
        BACKWARDS,
        /** From the first value to the last and back, in the same time. */
        THERE_AND_BACK
    }

    /** The value at a time, from 0 at the beginning to 1 at the end. */
    public double value(double time) {
        double part = switch (course) {
            case FORWARDS -> time;
            case BACKWARDS -> 1 - time;
            case THERE_AND_BACK -> 1 - Math.abs(1 - 2 * time);
        };
        double between = NumberText.rounded(from + part * (to - from), digits());
        // rounding must not lead beyond the ends, which may be the last numbers that are allowed
        return part == 0 ? from : part == 1 ? to : Math.max(Math.min(from, to), Math.min(Math.max(from, to), between));
    }

    /** The digits of values: more if the ends share their first digits. */
    private int digits() {
        double ratio = Math.max(Math.abs(from), Math.abs(to)) / Math.abs(to - from);
        return ratio > 1 ? (int) Math.min(MOST_DIGITS, DIGITS + Math.floor(Math.log10(ratio))) : DIGITS;
    }

    /** The time at which it has a value: an end if it does not reach it, and of two that nearer to a given one. */
    public double time(double value, double near) {
        double part = from == to ? 0 : Math.max(0, Math.min(1, (value - from) / (to - from)));
        return switch (course) {
            case FORWARDS -> part;
            case BACKWARDS -> 1 - part;
            case THERE_AND_BACK -> near <= 0.5 ? part / 2 : 1 - part / 2;
        };
    }

    /** The studio at a time, from 0 to 1. */
    public Studio studio(Studio studio, double time) {
        return number.with(studio, value(time));
    }

    /** Number of frames in a file. */
    public int frames() {
        return Math.max(2, (int) Math.round(seconds * frameRate));
    }

    /** The time of a frame; the last frame of a loop comes before its first one and does not repeat it. */
    public double timeOf(int frame) {
        return (double) frame / (course == Course.THERE_AND_BACK ? frames() : frames() - 1);
    }

    /** The photographs in which the number of a studio runs. */
    public FrameSequence sequence(Studio studio) {
        int count = frames();
        return new FrameSequence() {
            @Override
            public int frames() {
                return count;
            }

            @Override
            public int frameRate() {
                return frameRate;
            }

            @Override
            public Studio studio(int frame) {
                return Animation.this.studio(studio, timeOf(frame));
            }
        };
    }
}
