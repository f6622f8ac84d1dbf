package tompkins;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/** Processor time, which says how much work something is, however busy the machine is with other things. */
public final class ProcessorTime {

    private static final int TURNS = 7;

    private ProcessorTime() {}

    /** Something that is done, and may fail in some way. */
    public interface Work<E extends Exception> {

        /** Does it. */
        void run() throws E;
    }

    /** The processor time of all threads of this process while something is done, in seconds. */
    public static <E extends Exception> double ofProcess(Work<E> work) throws E {
        OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        long before = system.getProcessCpuTime();
        work.run();
        return (system.getProcessCpuTime() - before) * 1e-9;
    }

    /**
     * How many times the processor time of one thing another one takes, both by the present thread: the ratio of the
     * least of several times, in turns, because Java compiles and tidies up meanwhile.
     */
    public static <E extends Exception> double ratio(Work<E> work, Work<E> other) throws E {
        long least = Long.MAX_VALUE;
        long leastOfOther = Long.MAX_VALUE;
        for (int turn = 0; turn < TURNS; turn++) {
            least = Math.min(least, ofThread(work));
            leastOfOther = Math.min(leastOfOther, ofThread(other));
        }
        return (double) least / leastOfOther;
    }

    private static <E extends Exception> long ofThread(Work<E> work) throws E {
        long before = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        work.run();
        return Math.max(1, ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - before);
    }
}
