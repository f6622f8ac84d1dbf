package tompkins.ray;

/**
 * An object whose own fields lie 64 bytes, the length of a cache line, behind what comes before it in memory. The
 * objects that a thread keeps and uses for each ray extend this, and the job that all threads ask whether to go on.
 * Without it the garbage collector puts those of different threads side by side, and where one thread writes to the
 * line that another one reads, each waits for the other (false sharing).
 */
@SuppressWarnings("unused") // only the room that they take counts
public abstract class Padded {
    // in the gap behind the header, where Java would put a short field of a subclass
    private int room0;

    private long room1;
    private long room2;
    private long room3;
    private long room4;
    private long room5;
    private long room6;
    private long room7;
    private long room8;
}
