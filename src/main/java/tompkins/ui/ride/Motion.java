package tompkins.ui.ride;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import tompkins.explain.Flashes;
import tompkins.image.PictureLabel;
import tompkins.measure.Sighting;
import tompkins.property.InvalidPropertyException;
import tompkins.spacetime.Event;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.LensEvent;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.ui.animate.AnimationExport;
import tompkins.ui.animate.PlayPanel;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.photograph.Captions;
import tompkins.ui.photograph.WindowParts;
import tompkins.ui.picture.Picture;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.TabStrip;
import tompkins.ui.widget.Texts;

/** What moves in the window: an animation or a ride, with their tabs under the photograph, and the camera by hand. */
public final class Motion {

    /** A ride begins so far on the way to what was chosen. */
    private static final double NEAR = 0.9;

    private final WindowParts window;
    private final PictureCanvas canvas;
    private final AnimationExport export;
    private final Captions captions;
    private final RidePilot pilot;
    private final SteeringMouse steering;
    private final RideKeys keys;
    private final TabStrip strip;

    // made when they are first wanted
    private PlayPanel play;
    private RidePanel ride;

    /** What moves in a window, with its tabs in a strip. */
    public Motion(WindowParts window, TabStrip strip, AnimationExport export, Captions captions) {
        this.window = window;
        this.strip = strip;
        this.export = export;
        this.captions = captions;
        canvas = window.view().canvas();
        pilot = new RidePilot(window.model(), window.status()::report);
        steering = new SteeringMouse(canvas, new Steering(window.model(), window.view(), pilot));
        keys = new RideKeys(canvas, pilot, steering::turn);
        canvas.addOverlay((g, picture, bounds, visible, free) -> paintLine(g, free));
        captions.setRidden(this::isOnRide);
        pilot.addListener(canvas::repaint);
        pilot.addListener(this::complete);
        strip.fill(
                TabStrip.Tab.PLAY,
                () -> playPanel().component(),
                shown -> playPanel().setShown(shown));
        strip.fill(
                TabStrip.Tab.RIDE,
                () -> ridePanel().component(),
                shown -> ridePanel().setShown(shown));
        window.view().setRideAtRest(pilot::atRest);
        window.model().addOpenListener(this::pause);
    }

    /** The picture is completed when a ride pauses. */
    private void complete() {
        if (!pilot.isRiding()) {
            window.view().render();
        }
    }

    /** Who steers the ride. */
    public RidePilot pilot() {
        return pilot;
    }

    /** Pauses what moves by itself. */
    public void pause() {
        pilot.setRiding(false);
        if (play != null) {
            play.setPlaying(false);
        }
    }

    /** Pauses what moves by itself; false if nothing did. */
    public boolean pauseIfMoving() {
        boolean moves = play != null && play.isPlaying() || pilot.isRiding();
        pause();
        return moves;
    }

    private PlayPanel playPanel() {
        if (play == null) {
            play = new PlayPanel(window.model(), export::ask, captions::setAnimated);
        }
        return play;
    }

    /** Takes what is half typed, which would otherwise stop an animation at once. */
    private void takeEntries() {
        EntryField.takeAll(window.frame());
    }

    /** Ends a ride, and shows the animation. */
    private PlayPanel openPlay() {
        takeEntries();
        pilot.setRiding(false);
        strip.open(TabStrip.Tab.PLAY);
        return playPanel();
    }

    /** Animates a number. */
    public void play(NumberProperty property) {
        openPlay().run(property);
    }

    /** Lets the light of flashes travel. */
    public void playLight() {
        Optional<Picture> shown = Optional.ofNullable(canvas.shown().now());
        openPlay().runLight(shown.flatMap(picture -> new Flashes(picture.plan()).litTimes()));
    }

    /** Plays the animation, or pauses it. */
    public void togglePlay() {
        PlayPanel panel = openPlay();
        panel.setPlaying(!panel.isPlaying());
    }

    /** Begins a ride, or pauses it. */
    public void toggleRide() {
        takeEntries();
        strip.open(TabStrip.Tab.RIDE);
        pilot.setRiding(!pilot.isRiding());
        canvas.requestFocusInWindow();
    }

    /** Turns the camera to what is at a place of the picture. */
    public void lookAt(Point2D place) {
        steering.lookAt(place);
    }

    /** Begins a ride at rest, close before what is seen. */
    public void rideFrom(Sighting seen) {
        pause();
        Studio studio = window.model().studio();
        Event lens = LensEvent.inScene(studio);
        Vector3d place = lens.position().lerp(seen.inScene().position(), NEAR, new Vector3d());
        Velocity rest = Velocity.of(SpeedScale.BETA, 0, studio.velocity().givenDirection());
        Event start = new Event(place.x, place.y, place.z, lens.time());
        try {
            window.model().set(LensEvent.moved(studio, start, rest, new Quaterniond()));
            toggleRide();
        } catch (InvalidPropertyException tooFar) {
            window.view().fail(tooFar);
        }
    }

    /** Shows the recorded ride of the scene. */
    public void replayRide() {
        takeEntries();
        strip.open(TabStrip.Tab.RIDE);
        pilot.replayScene();
    }

    private RidePanel ridePanel() {
        if (ride == null) {
            ride = new RidePanel(
                    window.model(),
                    window.settings(),
                    pilot,
                    canvas::requestFocusInWindow,
                    export::askForRide,
                    keys::setKeyboard);
        }
        return ride;
    }

    private void paintLine(Graphics2D g, Rectangle free) {
        if (isOnRide()) {
            Font font = Look.captions();
            Rectangle below = PictureLabel.paintParts(g, font, parts(pilot.moment()), free);
            RideTask.Verdict verdict = pilot.task().verdict();
            if (verdict != null) {
                // below the rest, where it can be read from the back row
                PictureLabel.paintParts(g, font, List.of(verdict.text()), below);
            }
        }
    }

    /** Whether the camera is on a ride, which may be paused. */
    private boolean isOnRide() {
        return ride != null && ride.isShown() && pilot.moment() != null;
    }

    /** What the line at the top of the picture says. */
    private List<String> parts(RideMoment moment) {
        List<String> parts = new ArrayList<>(state(moment));
        parts.addAll(Captions.parts(moment, pilot.isRiding()));
        return parts;
    }

    private List<String> state(RideMoment moment) {
        String key = pilot.isReplaying()
                ? "ride.state.replay"
                : pilot.isRecording()
                        ? "ride.state.recording"
                        : pilot.isRiding()
                                ? pilot.isBraking()
                                                && !moment.studio().velocity().isRest()
                                        ? "ride.state.brake"
                                        : ""
                                : moment.properTime() == 0 ? "ride.state.ready" : "ride.state.pause";
        return key.isEmpty() ? List.of() : List.of(Texts.get(key));
    }
}
