package tompkins.ui;

import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.joml.Vector3dc;
import tompkins.animation.Animation;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.studio.FrontWindow;
import tompkins.studio.RideMoment;
import tompkins.ui.model.StudioModel;
import tompkins.ui.panel.NumberProperty;
import tompkins.ui.panel.PlayPanel;
import tompkins.ui.panel.RidePanel;
import tompkins.ui.panel.RidePilot;
import tompkins.ui.picture.Pace;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.picture.RideHeadUp;
import tompkins.ui.picture.RideKeys;
import tompkins.ui.picture.SteeringMouse;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Texts;

/** What moves in the window: an animation or a ride, with their bars under the photograph, and the camera by hand. */
final class Motion {

    /** Share of the field of view by which a key turns during a ride. */
    private static final double TURN = 0.03;

    private final JFrame frame;
    private final StudioModel model;
    private final PictureCanvas canvas;
    private final AnimationExport export;
    private final Captions captions;
    private final RidePilot pilot;
    private final JPanel bars =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 0, fillx, wrap 1, hidemode 3", "[grow,fill]"));

    // made when they are first wanted
    private PlayPanel play;
    private RidePanel ride;

    Motion(
            JFrame frame,
            StudioModel model,
            PhotographView view,
            StatusBar status,
            AnimationExport export,
            Captions captions) {
        this.frame = frame;
        this.model = model;
        this.export = export;
        this.captions = captions;
        canvas = view.canvas();
        pilot = new RidePilot(model, status::report);
        new SteeringMouse(canvas, new CameraHand(model, view, pilot));
        new RideKeys(canvas, new Keys());
        canvas.addOverlay(new RideHeadUp(this::line));
        pilot.addListener(() -> captions.setRiding(pilot.isRiding()));
        pilot.addListener(canvas::repaint);
        view.setRideAtRest(pilot::atRest);
    }

    /** The bars, to be put under the photograph. */
    JPanel bars() {
        return bars;
    }

    RidePilot pilot() {
        return pilot;
    }

    /** How soon a picture of a change has to come. */
    Pace pace() {
        return pilot.isRiding() ? Pace.RIDE : isPlaying() ? Pace.FILM : Pace.HAND;
    }

    /** Pauses what moves by itself. */
    void pause() {
        pilot.setRiding(false);
        if (play != null) {
            play.setPlaying(false);
        }
    }

    /** Pauses what moves by itself; false if nothing did. */
    boolean pauseIfMoving() {
        boolean moves = isPlaying() || pilot.isRiding();
        pause();
        return moves;
    }

    private boolean isPlaying() {
        return play != null && play.isPlaying();
    }

    private PlayPanel playPanel() {
        if (play == null) {
            play = new PlayPanel(model, export::ask, captions::setAnimated);
            bars.add(play.component());
        }
        return play;
    }

    /** Takes what is half typed, which would otherwise stop an animation at once. */
    private void takeEntries() {
        EntryField.takeAll(frame);
    }

    /** Animates a number. */
    void play(NumberProperty property) {
        takeEntries();
        pilot.setRiding(false);
        playPanel().run(property);
    }

    /** Plays the animation, or pauses it. */
    void togglePlay() {
        takeEntries();
        pilot.setRiding(false);
        playPanel().setShown(true);
        playPanel().setPlaying(!playPanel().isPlaying());
    }

    /** Shows the bar of the animation, or hides it. */
    void togglePlayPanel() {
        playPanel().setShown(!playPanel().isShown());
    }

    /** The animation that the bar describes; none if what is typed into it is refused. */
    Optional<Animation> wantedAnimation() {
        takeEntries();
        playPanel().setShown(true);
        return playPanel().wanted();
    }

    /** Begins a ride, or pauses it. */
    void toggleRide() {
        takeEntries();
        if (play != null) {
            play.setPlaying(false);
        }
        showRidePanel();
        pilot.setRiding(!pilot.isRiding());
        canvas.requestFocusInWindow();
    }

    /** Hides the bars, and pauses what moves. */
    void closeBars() {
        if (ride != null) {
            ride.setShown(false);
        }
        if (play != null) {
            play.setShown(false);
        }
    }

    /** Shows a recorded ride. */
    void replayRide() {
        takeEntries();
        showRidePanel();
        pilot.replay();
    }

    private void showRidePanel() {
        if (ride == null) {
            ride = new RidePanel(model, pilot, canvas::requestFocusInWindow, export::askForRide);
            bars.add(ride.component());
        }
        ride.setShown(true);
    }

    /** What the line at the top of the picture says; empty if the camera is not on a ride. */
    private String line() {
        RideMoment moment = pilot.moment();
        return moment == null || ride == null || !ride.isShown() ? "" : state() + Captions.of(moment);
    }

    private String state() {
        String key = pilot.isReplaying()
                ? "ride.state.replay"
                : pilot.isRecording()
                        ? "ride.state.recording"
                        : !pilot.isRiding() ? "ride.state.pause" : pilot.isBraking() ? "ride.state.brake" : "";
        return key.isEmpty() ? "" : Texts.get(key) + " \u00b7 ";
    }

    /** What the keys do during a ride. */
    private final class Keys implements RideKeys.Pilot {

        @Override
        public boolean isFlying() {
            return pilot.isRiding() && !pilot.isReplaying();
        }

        @Override
        public void thrust(Vector3dc direction) {
            pilot.setThrust(direction);
        }

        @Override
        public void stop() {
            pilot.stopThrust();
        }

        @Override
        public void brake() {
            pilot.brake();
        }

        @Override
        public void turn(int right, int up) {
            Camera camera = model.studio().camera();
            double angle = TURN * Math.toRadians(camera.horizontalAngleDegrees());
            Camera turned = new Aim(right * angle, up * angle).turn(camera);
            model.adjust(FrontWindow.held(model.studio(), turned), pilot.gesture());
        }
    }
}
