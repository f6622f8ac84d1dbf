package tompkins.ui.photograph;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.Timer;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import tompkins.measure.Sighting;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.trace.SampleHistory;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.RenderController;
import tompkins.ui.ray.PixelReading;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.ShortLabel;
import tompkins.ui.widget.Texts;

/** The line under the photograph: what is under the mouse, and how far the picture is. */
public final class StatusBar extends Part {

    private static final int STEPS = 100;

    /** How long a message about what has happened stays: enough to read a long path. */
    private static final int MESSAGE_MILLISECONDS = 8000;

    private final JLabel what = new ShortLabel("status.what");
    private final JLabel where = new JLabel(" ");
    private final JLabel picture = new JLabel(" ");
    private final JProgressBar progress = new JProgressBar(0, STEPS);
    private final RenderController controller;
    private final Timer timer;
    private final Timer fading;
    private String failure;

    /** What is under the mouse; null if nothing is. */
    private PixelReading read;

    /** The hint for the picture if there is nothing else to say; empty if there is none. */
    private String pictureHint = "";

    /** What a click does; empty if there may be something better to say. */
    private String click = "";

    /** The picture on the screen while the line says that it is being refined; otherwise null. */
    private Picture refining;

    /** A status bar that shows the progress of a controller. */
    public StatusBar(RenderController controller) {
        this(controller, MESSAGE_MILLISECONDS);
    }

    /** The same, with the time for which messages about what has happened stay. */
    public StatusBar(RenderController controller, int messageMilliseconds) {
        super(new JPanel(new MigLayout("novisualpadding, insets 4 10 5 10, fillx, gap 12 1", "[grow,fill][pref!]")));
        this.controller = controller;
        fading = new Timer(messageMilliseconds, event -> {
            setWhat("");
            show(read, false);
        });
        fading.setRepeats(false);
        where.setName("status.where");
        where.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        picture.setName("status.picture");
        progress.setName("status.progress");
        progress.getAccessibleContext().setAccessibleName(Texts.get("status.progress"));
        progress.setVisible(false);
        panel.add(what, "wmin 0");
        panel.add(picture, "wrap, alignx right");
        panel.add(where, "wmin 0, span 2, split 2, growx, pushx");
        panel.add(progress, "w 120!, h 6!, aligny center, alignx right");
        showIdle();
        timer = new Timer(200, event -> {
            boolean busy = controller.isBusy();
            progress.setVisible(busy);
            progress.setValue((int) (controller.progress() * STEPS));
            if (controller.isStopped() && refining != null) {
                show(refining);
            }
        });
        timer.start();
    }

    /** Ends its timer, for a window that is closed. */
    public void stop() {
        timer.stop();
        fading.stop();
    }

    private void showIdle() {
        setWhat(failure == null ? hint() : failure);
        what.setForeground(UIManager.getColor(failure == null ? "Label.foreground" : "Tompkins.error"));
        where.setText(" ");
    }

    /** What is said if there is nothing else to say. */
    private String hint() {
        if (!click.isEmpty()) {
            return click;
        }
        return pictureHint.isEmpty() ? Texts.get("status.idle.PIN") : pictureHint;
    }

    private void setWhat(String text) {
        fading.stop();
        what.setText(text);
    }

    /** Says why there is no picture of the scene, until there is one. */
    public void fail(String message) {
        failure = message;
        showIdle();
        if (!picture.getText().isBlank()) {
            picture.setText(Texts.get("status.before"));
        }
    }

    /** There is a picture of the scene. */
    public void endFailure() {
        if (failure != null) {
            clear();
        }
    }

    /** Clears everything that was said about a scene. */
    public void clear() {
        failure = null;
        showIdle();
    }

    private static String end(Sighting sighting) {
        if (sighting.life() == null) {
            return Texts.get("probe.noShutter");
        }
        if (sighting.hit() != null) {
            return sighting.hit().object().description();
        }
        return Texts.get(sighting.life().reachesBackground() ? "probe.background" : "probe.standsStill");
    }

    /**
     * Shows what lies under the mouse, or a hint if that is nothing.
     *
     * @param rests whether the mouse has not moved, but the picture under it has changed
     */
    public void show(PixelReading reading, boolean rests) {
        read = reading;
        if (rests && fading.isRunning()) {
            // another picture under a mouse that rests does not hide news
            return;
        }
        if (reading == null || failure != null) {
            showIdle();
            return;
        }
        StringBuilder text = new StringBuilder(Texts.get("probe.pixel", reading.column(), reading.row()))
                .append("  \u00b7  ")
                .append(end(reading.sighting()));
        if (Double.isFinite(reading.sighting().cameraAngle())) {
            text.append("  \u00b7  ").append(angle(reading.sighting()));
        }
        setWhat(text.toString());
        where.setText(details(reading.sighting()));
        Naming.tip(where, where.getText());
    }

    private static String details(Sighting sighting) {
        List<String> details = new ArrayList<>();
        boolean moves = Double.isFinite(sighting.cameraAngle()) || sighting.dopplerFactor() != 1;
        if (moves && !Double.isNaN(sighting.dopplerFactor())) {
            details.add(Texts.get("probe.ratio", Numbers.brief(sighting.dopplerFactor(), 4)));
        }
        SampleHistory.Encounter hit = sighting.hit();
        if (hit != null) {
            details.add(
                    Texts.get("status.events", Numbers.brief(sighting.inScene()), Numbers.brief(sighting.inCamera())));
            if (hit.movesByItself()) {
                details.add(
                        Texts.get("status.ownEvent", Numbers.brief(hit.rest().event())));
            }
        }
        return details.isEmpty() ? " " : String.join("   \u00b7   ", details);
    }

    private static String angle(Sighting sighting) {
        String inCamera = Numbers.brief(Math.toDegrees(sighting.cameraAngle()), 4);
        return Double.isNaN(sighting.sceneAngle())
                ? Texts.get("status.cameraAngle", inCamera)
                : Texts.get("status.angles", inCamera, Numbers.brief(Math.toDegrees(sighting.sceneAngle()), 4));
    }

    /** Describes the picture on the screen. */
    public void show(Picture shown) {
        // a picture that was rendered before the stop may reach the screen after it
        boolean ended = shown.complete() || controller.isStopped();
        refining = ended ? null : shown;
        if (failure != null) {
            return;
        }
        showHint(shown);
        String key = shown.complete() ? "status.complete" : ended ? "status.stopped" : "status.refining";
        long milliseconds = shown.time().toMillis();
        String samples = Numbers.brief(shown.samples(), 3);
        picture.setText(Texts.get(
                        key,
                        shown.width(),
                        shown.height(),
                        Texts.get(samples.equals("1") ? "status.sample" : "status.samples", samples),
                        milliseconds < 1000 ? milliseconds + " ms" : Numbers.brief(milliseconds / 1000.0, 3) + " s",
                        Double.isNaN(shown.error()) ? "" : Texts.get("status.error", Numbers.brief(shown.error(), 2)))
                + (shown.plan().isTooFaint() ? Texts.get("status.tooFaint") : "")
                + (shown.isTooSharp() ? Texts.get("status.tooSharp") : ""));
        Naming.tip(picture, Texts.get("status.errorTip"));
    }

    private void showHint(Picture now) {
        boolean shown = what.getText().equals(hint());
        pictureHint = hint(now);
        if (shown) {
            showIdle();
        }
    }

    private static String hint(Picture picture) {
        if (isEmpty(picture.studio())) {
            return Texts.get("status.empty");
        }
        return picture.warnings().isEmpty()
                ? ""
                : Texts.get("status.warning", picture.warnings().get(0));
    }

    private static boolean isEmpty(Studio studio) {
        return studio.scene().isEmpty()
                && studio.cameraFrame().isEmpty()
                && !(studio.background() instanceof PanoramaBackground)
                && !(studio.background() instanceof StarSky);
    }

    /** Says what a click does from now on. */
    public void showHint(String now) {
        if (!now.equals(click)) {
            click = now;
            showIdle();
        }
    }

    /** Shows one line of text, until there is something else to read under the mouse. */
    public void say(String message) {
        what.setForeground(UIManager.getColor("Label.foreground"));
        setWhat(message);
        where.setText(" ");
    }

    /** As {@link #say}, for news that disappear after a while; an empty one takes back the last. */
    public void report(String message) {
        if (message.isEmpty()) {
            show(read, false);
        } else {
            say(message);
            fading.restart();
        }
    }
}
