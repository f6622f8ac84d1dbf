package tompkins.ui.ride;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.Timer;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.animation.RideFilm;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Ride;
import tompkins.studio.RideMoment;
import tompkins.studio.RideRecorder;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Texts;

/**
 * Rides with the camera of a model: time runs, thrust changes the velocity, and what happens can be recorded and
 * replayed. A whole ride is one step of the history. It ends when something else changes where the camera is.
 */
public final class RidePilot {

    /** As often as pictures can be made. */
    private static final int TICK_MILLISECONDS = 16;

    /** After a longer pause of the program the ride goes on as if there had been none. */
    private static final double LONGEST_STEP_SECONDS = 0.25;

    /** The rapidity that thrust gives in a second on board, however slow light is there. */
    private static final double RAPIDITY_PER_SECOND = 0.5;

    private final StudioModel model;
    private final Consumer<String> teller;
    private final List<Runnable> listeners = new ArrayList<>();
    private final Object gesture = new Object();
    private final Timer timer = new Timer(TICK_MILLISECONDS, event -> tick());
    private final Vector3d wish = new Vector3d();
    private boolean braking;
    private boolean answering;
    private double unitsPerSecond = 1;
    private RideKeyboard keyboard = RideKeyboard.common().get(0);

    /** Where the ride began that is flown; null before the first. */
    private Studio start;

    private final RideTask task = new RideTask();
    private RideMoment moment;

    /** Takes note of what is flown by hand; null before that. */
    private RideRecorder recorder;

    /** Whether that will be kept in the scene. */
    private boolean keeps;

    /** The ride that is shown, or was shown last; null if it was flown by hand. */
    private RideFilm film;

    private double filmTime;
    private long lastTick;

    /** A pilot for the camera of a model; messages about the ride go to {@code teller}. */
    public RidePilot(StudioModel model, Consumer<String> teller) {
        this.model = model;
        this.teller = teller;
    }

    /** Calls a listener when a ride begins or ends, or a recording does. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }

    /** Whether time runs. */
    public boolean isRiding() {
        return timer.isRunning();
    }

    /** Whether thrust and turns lead it. */
    boolean isFlying() {
        return isRiding() && film == null;
    }

    /** Whether the ride is recorded. */
    public boolean isRecording() {
        return keeps;
    }

    /** Whether a recorded ride is shown. */
    public boolean isReplaying() {
        return isRiding() && film != null;
    }

    /** The gesture to which all changes of a ride belong. */
    public Object gesture() {
        return gesture;
    }

    /** Says how to go on, if there is a ride that no key steers now. */
    void tellThatItPauses() {
        if (moment() != null) {
            teller.accept(Texts.get(isRiding() ? "ride.steerReplay" : "ride.steerPause"));
        }
    }

    /** The present moment of the ride, which may be paused; null if the camera has been moved elsewhere since. */
    public RideMoment moment() {
        Studio now = model.studio();
        return moment == null || !moment.isOf(now) ? null : moment.with(now);
    }

    /**
     * The present studio as a camera at rest takes it at the same event, which in the frame of a moving camera has
     * other coordinates; null if the camera is not on a ride, nor on one that pauses.
     */
    public Studio atRest() {
        RideMoment now = moment();
        return now == null ? null : now.atRest();
    }

    /** Where thrust is wished, at once: each component from -1 to 1, to the right, up and forwards. */
    public void setThrust(Vector3dc direction) {
        steer(direction, braking && direction.lengthSquared() == 0);
    }

    /** Ends thrust and braking. */
    public void stopThrust() {
        steer(new Vector3d(), false);
    }

    /** Brakes until the camera is at rest in the scene. */
    public void brake() {
        steer(new Vector3d(), true);
    }

    private void steer(Vector3dc direction, boolean brakes) {
        wish.set(direction);
        braking = brakes;
        if (isRiding()) {
            answering = true;
            tick();
            answering = false;
        }
    }

    /** Whether the present change answers a hand, and has to be seen as soon as possible. */
    boolean isAnswering() {
        return answering;
    }

    /** What to try on the ride. */
    RideTask task() {
        return task;
    }

    /** Goes back to where the ride began; a recording ends there, too. */
    public void home() {
        if (keeps) {
            setRecording(false);
        } else if (start != null && moment() != null) {
            wish.zero();
            braking = false;
            flyFrom(RideMoment.start(model.studio().withCamera(start.camera()).withVelocity(start.velocity())));
            task.restart(true);
            teller.accept(task.news());
            tell();
            model.look(moment.studio(), gesture);
        }
    }

    /** The keyboard whose letters steer. */
    RideKeyboard keyboard() {
        return keyboard;
    }

    /** Lets the letters of another keyboard steer from now on. */
    void setKeyboard(RideKeyboard other) {
        keyboard = other;
    }

    /** Whether it brakes. */
    public boolean isBraking() {
        return braking;
    }

    /** How far light goes in a second of the ride, in scene units; above 0. */
    public void setUnitsPerSecond(double units) {
        unitsPerSecond = units;
    }

    /** How far light goes in a second of the ride, in scene units. */
    public double unitsPerSecond() {
        return unitsPerSecond;
    }

    /** Begins or continues a ride, or pauses it; a recording is then kept in the scene. */
    public void setRiding(boolean riding) {
        if (riding == isRiding()) {
            return;
        }
        if (riding) {
            begin();
        } else {
            end();
        }
        tell();
    }

    private void begin() {
        if (moment() == null) {
            List<Ride> rides = model.studio().rides();
            if (model.isAtHome() && !rides.isEmpty()) {
                attempt(() -> goToStart(rides.get(0)));
            }
            if (moment() == null) {
                startFrom(model.studio());
            }
        } else if (film != null) {
            flyFrom(moment());
        }
        stopThrust();
        lastTick = System.nanoTime();
        timer.start();
    }

    private void startFrom(Studio beginning) {
        start = beginning;
        task.clear();
        flyFrom(RideMoment.start(beginning));
    }

    private void flyFrom(RideMoment now) {
        film = null;
        moment = now;
        recorder = new RideRecorder(now.studio());
    }

    private void goToStart(Ride ride) {
        unitsPerSecond = ride.lightSpeed();
        startFrom(ride.start(model.atHome()));
        model.look(moment.studio(), gesture);
        task.begin(ride);
    }

    /** Rides from the start of a ride of the scene; a challenge waits there until it is read. */
    void begin(Ride ride) {
        setRiding(false);
        attempt(() -> {
            goToStart(ride);
            setRiding(ride.challenge().isEmpty());
            tell();
        });
    }

    /** After a recording the scene goes back to where the recorded ride begins, with the ride in it. */
    private void end() {
        timer.stop();
        boolean kept = keeps && !recorder.isEmpty();
        keeps = false;
        if (kept) {
            model.adjust(recorder.studio(), gesture);
            teller.accept(Texts.get("ride.recorded", String.format(Locale.ROOT, "%.1f", recorder.seconds())));
        }
        model.endGesture(gesture);
    }

    /** Begins to record, and to ride; or ends both. */
    public void setRecording(boolean recording) {
        setRiding(recording);
        if (recording) {
            flyFrom(RideMoment.start(model.studio()));
            task.restart(true);
            keeps = true;
            tell();
        }
    }

    /** Whether there is something to replay. */
    public boolean canReplay() {
        return moment() == null
                ? !model.studio().ride().isEmpty()
                : !start.ride().isEmpty() || !recorder.isEmpty();
    }

    /** Where what can be replayed begins: the flight that the ride comes with, or what was flown; else the present. */
    public Studio beginning() {
        return moment() == null ? model.unmoved() : start.ride().isEmpty() ? recorder.studio() : start;
    }

    /** Shows the ride that begins with {@link #beginning}. */
    public void replay() {
        setRiding(false);
        replay(beginning(), moment() != null);
    }

    /** Shows the ride that is recorded in the scene, also after others; if there is none, as {@link #replay}. */
    public void replayScene() {
        setRiding(false);
        if (model.studio().ride().isEmpty() && !model.opened().ride().isEmpty()) {
            replay(model.opened(), false);
        } else {
            replay();
        }
    }

    private void replay(Studio beginning, boolean same) {
        if (beginning.ride().isEmpty()) {
            teller.accept(Texts.get("ride.nothingRecorded"));
            return;
        }
        attempt(() -> {
            film = new RideFilm(beginning);
            filmTime = 0;
            moment = film.moment(0.0);
            start = same ? start : beginning;
            task.restart(same);
            model.look(moment.studio(), gesture);
            lastTick = System.nanoTime();
            timer.start();
        });
        tell();
    }

    private void tick() {
        long now = System.nanoTime();
        double seconds = Math.min(LONGEST_STEP_SECONDS, (now - lastTick) * 1e-9);
        lastTick = now;
        if (!follow(model.studio())) {
            setRiding(false);
            return;
        }
        attempt(() -> {
            if (film != null) {
                filmTime += seconds;
                go(film.moment(filmTime));
            } else {
                ride(seconds);
            }
            model.flow(moment.studio(), gesture);
            if (film != null && filmTime >= film.seconds()) {
                setRiding(false);
            }
        });
    }

    /** Takes changes by others: another view or other lights are part of the ride, another place is not; false then. */
    private boolean follow(Studio studio) {
        boolean follows = film == null && moment.isOf(studio);
        if (follows) {
            moment = moment.with(studio);
        }
        return follows || studio.equals(moment.studio());
    }

    private void ride(double seconds) {
        double strength = RAPIDITY_PER_SECOND / unitsPerSecond;
        double properTime = unitsPerSecond * seconds;
        if (braking) {
            double needed = moment.rider().rapidity() / strength;
            double part = Math.min(needed, properTime);
            step(moment.brake(strength), part);
            step(new Vector3d(), properTime - part);
        } else {
            double length = wish.length();
            step(wish.mul(length > 1 ? strength / length : strength, new Vector3d()), properTime);
        }
    }

    private void step(Vector3dc thrust, double properTime) {
        if (properTime > 0) {
            RideMoment next = moment.after(thrust, properTime);
            recorder.add(moment.studio(), thrust, properTime, properTime / unitsPerSecond, next.studio());
            go(next);
        }
    }

    private void go(RideMoment next) {
        boolean hasNews = task.follow(moment, next);
        moment = next;
        if (hasNews) {
            teller.accept(task.news());
            tell();
        }
    }

    /** A camera that gets too fast, or too far away, ends the ride. */
    private void attempt(Runnable action) {
        try {
            action.run();
        } catch (InvalidPropertyException refused) {
            setRiding(false);
            teller.accept(Texts.get("ride.ended", Messages.of(refused)));
        }
    }
}
