package tompkins.ui.file;

import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import tompkins.render.Progress;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/** Work that takes a while, away from the event thread; a small window shows how far it is, and can cancel it. */
public final class BackgroundTask implements Progress {

    /** What a task does, on a thread of its own. */
    public interface Work<T> {

        /**
         * Does the work, and returns what comes of it.
         *
         * @throws java.util.concurrent.CancellationException if the task was cancelled before it was too late for that
         */
        T run(Progress progress) throws Exception;
    }

    private static final int STEPS = 1000;

    /** Widths of the window in sizes of its type: titles name files, with their folders. */
    private static final int NARROWEST = 25;

    private static final int WIDEST = 60;

    /** Shorter work shows no window. */
    private static final int PATIENCE_MILLISECONDS = 400;

    /** The share of the work that must be done before the rest is estimated. */
    private static final double LEAST_SHARE = 0.01;

    private static final double LONGEST_IN_SECONDS = 100;

    /** The tasks that run at the moment; used by the event thread alone. */
    private static final List<BackgroundTask> RUNNING = new ArrayList<>();

    /** What waits for the end of tasks, in its order; used by the event thread alone. */
    private static final List<Waiting> WAITING = new ArrayList<>();

    /** A step of a window that is done when none of some tasks runs any more. */
    private record Waiting(Window owner, Predicate<BackgroundTask> blocking, Runnable step) {

        boolean isFree() {
            return RUNNING.stream().noneMatch(blocking);
        }
    }

    private final Window owner;
    private final String title;
    private final JProgressBar bar = new JProgressBar(0, STEPS);
    private final long start = System.nanoTime();
    private volatile double progress;
    private volatile boolean cancelled;

    /** The file that it writes; null if there is none. */
    private Path file;

    /** The small window, or null before it is shown for the first time: most work is done before that. */
    private JDialog dialog;

    private BackgroundTask(Window owner, String title) {
        this.owner = owner;
        this.title = title;
    }

    private JDialog dialog() {
        JDialog made = new JDialog(owner, title);
        String column = "[" + Look.pixels(NARROWEST) + ":pref:" + Look.pixels(WIDEST) + ",fill]";
        JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 16, wrap 1, gap 0 12", column));
        panel.add(new JLabel(title));
        panel.add(bar);
        JButton cancel = new JButton(Texts.get("task.cancel"));
        cancel.setName(Texts.get("task.cancel"));
        cancel.addActionListener(event -> cancelled = true);
        Keys.bindEscape(made.getRootPane(), cancel::doClick);
        bar.getAccessibleContext().setAccessibleName(title);
        bar.setStringPainted(true);
        panel.add(cancel, "growx 0, alignx right");
        made.setContentPane(panel);
        // keys that are typed meanwhile are not meant for it
        made.setAutoRequestFocus(false);
        made.setName("task");
        made.setDefaultCloseOperation(JDialog.DO_NOTHING_ON_CLOSE);
        made.pack();
        made.setResizable(false);
        made.setLocationRelativeTo(owner);
        return made;
    }

    /**
     * Starts work. Called by the event thread.
     *
     * @param done takes on the event thread what came of the work if it was done, even if Cancel came too late
     * @param notDone called on the event thread if it was cancelled
     */
    public static <T> BackgroundTask start(
            Window owner, String title, Work<T> work, Consumer<? super T> done, Runnable notDone) {
        BackgroundTask task = new BackgroundTask(owner, title);
        RUNNING.add(task);
        Timer timer = new Timer(PATIENCE_MILLISECONDS, event -> task.refresh());
        timer.start();
        Thread thread = new Thread(() -> task.run(work, timer, done, notDone), "tompkins-task");
        thread.setDaemon(true);
        thread.start();
        return task;
    }

    /**
     * Starts work that finds something and changes nothing, so that it can be cancelled up to its end. Called by the
     * event thread.
     *
     * @param done takes on the event thread what was found
     */
    public static <T> BackgroundTask find(Window owner, String title, Callable<T> work, Consumer<T> done) {
        return start(
                owner,
                title,
                task -> {
                    T found = work.call();
                    task.requireWanted();
                    return found;
                },
                done,
                () -> {});
    }

    /** Says which file the task writes, and no other task meanwhile. Called by the event thread. */
    public void into(Path written) {
        file = written.toAbsolutePath().normalize();
    }

    /**
     * Does a step of a window, such as saving, when no task writes a file any more. Called by the event thread.
     *
     * @return false if it has to wait
     */
    public static boolean whenFree(Window owner, Path wanted, Runnable step) {
        Path whole = wanted.toAbsolutePath().normalize();
        return await(new Waiting(owner, task -> whole.equals(task.file), step));
    }

    /** Does something when no task of a window runs any more. Called by the event thread. */
    public static void whenIdle(Window owner, Runnable step) {
        await(new Waiting(owner, task -> task.owner == owner, step));
    }

    private static boolean await(Waiting waiting) {
        boolean free = waiting.isFree();
        if (free) {
            waiting.step.run();
        } else {
            WAITING.add(waiting);
        }
        return free;
    }

    private static void goOn() {
        for (Waiting waiting : List.copyOf(WAITING)) {
            // a step may begin a task for which others wait
            if (waiting.isFree() && WAITING.remove(waiting)) {
                waiting.step.run();
            }
        }
    }

    /** The titles of the tasks that run for a window, which should not be closed before they end. */
    public static List<String> running(Window owner) {
        return RUNNING.stream()
                .filter(task -> task.owner == owner)
                .map(task -> task.title)
                .toList();
    }

    /** Brings forward the tasks that run for a window. Called by the event thread. */
    public static void showRunning(Window owner) {
        RUNNING.stream().filter(task -> task.owner == owner).forEach(BackgroundTask::show);
    }

    /** Cancels the tasks of a window, and drops what waits for them; false if none runs. Called by the event thread. */
    public static boolean cancel(Window owner) {
        WAITING.removeIf(waiting -> waiting.owner == owner);
        RUNNING.stream().filter(task -> task.owner == owner).forEach(task -> task.cancelled = true);
        return !running(owner).isEmpty();
    }

    /** Cancels the task of a window that was begun last and is not cancelled yet; what waits for it comes then. */
    public static void cancelLast(Window owner) {
        RUNNING.stream()
                .filter(task -> task.owner == owner && !task.cancelled)
                .reduce((earlier, later) -> later)
                .ifPresent(task -> task.cancelled = true);
    }

    private <T> void run(Work<T> work, Timer timer, Consumer<? super T> done, Runnable notDone) {
        Runnable end;
        try {
            T made = work.run(this);
            end = () -> done.accept(made);
        } catch (CancellationException stopped) {
            end = notDone;
        } catch (Exception | Error failure) {
            // whatever happened, a task that has ended must not count as running
            end = () -> Messages.error(
                    owner, Messages.isOfMemory(failure) ? title + ": " + Messages.of(failure) : Messages.of(failure));
        }
        Runnable last = end;
        SwingUtilities.invokeLater(() -> {
            timer.stop();
            RUNNING.remove(this);
            if (dialog != null) {
                dialog.dispose();
            }
            try {
                last.run();
            } finally {
                goOn();
            }
        });
    }

    private void refresh() {
        bar.setValue((int) (progress * STEPS));
        bar.setString(remaining(progress, (System.nanoTime() - start) / 1e9));
        // showing it again would take the focus from whatever the user does meanwhile
        if (dialog == null) {
            show();
        }
    }

    /** How long it will still take, estimated after some seconds; empty before enough is done. */
    static String remaining(double share, double seconds) {
        if (share < LEAST_SHARE) {
            return "";
        }
        double left = seconds * (1 - share) / share;
        return left < LONGEST_IN_SECONDS
                ? Texts.get("task.secondsLeft", Math.round(left))
                : Texts.get("task.minutesLeft", Math.round(left / 60));
    }

    private void show() {
        if (dialog == null) {
            dialog = dialog();
        }
        dialog.setVisible(true);
    }

    @Override
    public void setProgress(double share) {
        progress = share;
    }

    @Override
    public boolean isCancelled() {
        return cancelled;
    }
}
