package tompkins.light;

/** When a lamp shines, told by the time of the frame in which it rests. */
public sealed interface Flash permits AlwaysOn, Pulse {

    /** Whether the lamp sends out light at a time of its own. */
    boolean isLit(double ownTime);
}
