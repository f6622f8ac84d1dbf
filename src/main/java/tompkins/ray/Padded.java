package tompkins.ray;

/**
 * An object whose own fields lie 64 bytes, the length of a cache line, behind what comes before it in memory, so that
 * no thread waits for another one that writes to the same line (false sharing). What a thread keeps and uses for each
 * ray extends this, and the job that all threads ask whether to go on.
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
