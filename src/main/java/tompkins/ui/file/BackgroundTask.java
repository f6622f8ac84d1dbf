package tompkins.ui.file;

import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.SwingWorker;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import tompkins.render.Progress;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/**
 * Work that takes a while, away from the event thread; a small window shows how far it is, and can cancel it. All but
 * the work itself is for the event thread.
 */
public final class BackgroundTask<T> extends SwingWorker<T, Void> {

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

    /** The tasks that run at the moment. */
    private static final List<BackgroundTask<?>> RUNNING = new ArrayList<>();

    /** What windows do when none of their tasks runs any more. */
    private static final Map<Window, Runnable> WHEN_IDLE = new HashMap<>();

    private final Window owner;
    private final String title;
    private final Work<T> work;
    private final Consumer<? super T> taker;
    private final Runnable notDone;
    private final JProgressBar bar = new JProgressBar(0, STEPS);
    private final Timer timer = new Timer(PATIENCE_MILLISECONDS, event -> refresh());
    private volatile double share;

    /** What was done before it was cancelled is done: only the work knows whether it is too late to end. */
    private volatile boolean unwanted;

    /** The file that it writes; null if there is none. */
    private final Path file;

    /** The small window, or null before it is shown for the first time: most work is done before that. */
    private JDialog dialog;

    private BackgroundTask(
            Window owner, String title, Path file, Work<T> work, Consumer<? super T> taker, Runnable notDone) {
        this.owner = owner;
        this.title = title;
        this.file = file == null ? null : plain(file);
        this.work = work;
        this.taker = taker;
        this.notDone = notDone;
    }

    /**
     * Starts work.
     *
     * @param file what it writes, and no other task meanwhile; null if that is no file
     * @param done takes what came of the work if it was done, even if Cancel came too late
     * @param notDone called if it was cancelled
     */
    public static <T> void start(
            Window owner, String title, Path file, Work<T> work, Consumer<? super T> done, Runnable notDone) {
        BackgroundTask<T> task = new BackgroundTask<>(owner, title, file, work, done, notDone);
        RUNNING.add(task);
        task.timer.start();
        task.execute();
    }

    /**
     * Starts work that finds something and changes nothing, so that it can be cancelled up to its end.
     *
     * @param done takes what was found
     */
    public static <T> void find(Window owner, String title, Callable<T> work, Consumer<T> done) {
        Work<T> search = progress -> {
            T found = work.call();
            progress.requireWanted();
            return found;
        };
        start(owner, title, null, search, done, () -> {});
    }

    private static Path plain(Path file) {
        return file.toAbsolutePath().normalize();
    }

    /** Whether a task writes a file. */
    public static boolean isWriting(Path wanted) {
        return RUNNING.stream().anyMatch(task -> plain(wanted).equals(task.file));
    }

    /** Does something when no task of a window runs any more. */
    public static void whenIdle(Window owner, Runnable step) {
        if (of(owner).findAny().isEmpty()) {
            step.run();
        } else {
            WHEN_IDLE.put(owner, step);
        }
    }

    private static Stream<BackgroundTask<?>> of(Window owner) {
        return RUNNING.stream().filter(task -> task.owner == owner);
    }

    /** The titles of the tasks that run for a window, which should not be closed before they end. */
    public static List<String> running(Window owner) {
        return of(owner).map(task -> task.title).toList();
    }

    /** Cancels the tasks of a window; false if none runs. */
    public static boolean cancel(Window owner) {
        of(owner).forEach(task -> task.unwanted = true);
        return of(owner).findAny().isPresent();
    }

    /** Cancels the task of a window that was begun last and is not cancelled yet. */
    public static void cancelLast(Window owner) {
        of(owner)
                .filter(task -> !task.unwanted)
                .reduce((earlier, later) -> later)
                .ifPresent(task -> task.unwanted = true);
    }

    @Override
    protected T doInBackground() throws Exception {
        return work.run(new Progress() {
            @Override
            public void setProgress(double done) {
                share = done;
            }

            @Override
            public boolean isCancelled() {
                return unwanted;
            }
        });
    }

    @Override
    protected void done() {
        timer.stop();
        RUNNING.remove(this);
        if (dialog != null) {
            dialog.dispose();
        }
        try {
            taker.accept(get());
        } catch (ExecutionException failed) {
            fail(failed.getCause());
        } catch (InterruptedException impossible) {
            throw new IllegalStateException(impossible);
        } finally {
            if (WHEN_IDLE.containsKey(owner) && of(owner).findAny().isEmpty()) {
                WHEN_IDLE.remove(owner).run();
            }
        }
    }

    private void fail(Throwable failure) {
        if (failure instanceof CancellationException) {
            notDone.run();
        } else {
            Messages.error(
                    owner, Messages.isOfMemory(failure) ? title + ": " + Messages.of(failure) : Messages.of(failure));
        }
    }

    private void refresh() {
        bar.setValue((int) (share * STEPS));
        // showing it again would take the focus from whatever the user does meanwhile
        if (dialog == null) {
            dialog = dialog();
            dialog.setVisible(true);
        }
    }

    private JDialog dialog() {
        JDialog made = new JDialog(owner, title);
        String column = "[" + Look.pixels(NARROWEST) + ":pref:" + Look.pixels(WIDEST) + ",fill]";
        JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 16, wrap 1, gap 0 12", column));
        JButton cancel = new JButton(Texts.get("task.cancel"));
        cancel.setName(Texts.get("task.cancel"));
        cancel.addActionListener(event -> unwanted = true);
        Keys.bindEscape(made.getRootPane(), cancel::doClick);
        bar.getAccessibleContext().setAccessibleName(title);
        bar.setStringPainted(true);
        panel.add(new JLabel(title));
        panel.add(bar);
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
}
