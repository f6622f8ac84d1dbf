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
import tompkins.ui.model.Pace;
import tompkins.ui.model.StudioModel;
import tompkins.ui.ride.RideState.Flying;
import tompkins.ui.ride.RideState.Idle;
import tompkins.ui.ride.RideState.Replaying;
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
    private final Timer timer = new Timer(TICK_MILLISECONDS, event -> tick(Pace.RIDE));
    private final RideTask task = new RideTask();
    private RideState state = new Idle(false);

    /** The last ride; null before the first. */
    private RideTrip trip;

    private double unitsPerSecond = 1;
    private long lastTick;
    private Runnable whenBegun = () -> {};

    /** A pilot for the camera of a model; messages about the ride go to {@code teller}. */
    public RidePilot(StudioModel model, Consumer<String> teller) {
        this.model = model;
        this.teller = teller;
        model.addOpenListener(this::forget);
    }

    /** Calls a listener when a ride begins or ends, or a recording does, and when a challenge has news. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** Does something whenever a ride begins that was not there before, and does not only go on. */
    public void setWhenBegun(Runnable listener) {
        whenBegun = listener;
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }

    private void forget() {
        setRiding(false);
        trip = null;
        task.forget();
        tell();
    }

    /** Whether time runs. */
    public boolean isRiding() {
        return !(state instanceof Idle);
    }

    /** Whether thrust and turns lead it. */
    boolean isFlying() {
        return state instanceof Flying;
    }

    /** Whether the ride is recorded. */
    public boolean isRecording() {
        return state instanceof Flying flying && flying.records();
    }

    /** Whether a recorded ride is shown. */
    public boolean isReplaying() {
        return state instanceof Replaying;
    }

    /** Whether it brakes. */
    public boolean isBraking() {
        return state instanceof Flying flying && flying.brakes();
    }

    /** The gesture to which all changes of a ride belong. */
    public Object gesture() {
        return gesture;
    }

    /** The present moment of the ride, which may be paused; null if the camera has been moved elsewhere since. */
    public RideMoment moment() {
        Studio now = model.studio();
        return trip == null || !trip.moment().isOf(now) ? null : trip.moment().with(now);
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
        steer(direction, isBraking() && direction.lengthSquared() == 0);
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
        if (state instanceof Flying flying) {
            state = flying.steered(direction, brakes);
            tick(Pace.ANSWER);
        }
    }

    /** What to try on the ride. */
    RideTask task() {
        return task;
    }

    /** Goes back to where the ride began; a recording ends there, too. */
    public void home() {
        if (isRecording()) {
            setRecording(false);
        } else if (moment() != null) {
            Studio start = trip.start();
            trip = RideTrip.from(
                    start,
                    RideMoment.start(model.studio().withCamera(start.camera()).withVelocity(start.velocity())));
            state = isRiding() ? Flying.coasting(false) : new Idle(false);
            task.restart();
            teller.accept("");
            tell();
            model.look(trip.moment().studio(), gesture);
        }
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
            if (model.isAtHome(model.studio()) && !rides.isEmpty()) {
                attempt(() -> goToStart(rides.get(0)));
            }
            if (moment() == null) {
                task.begin(Ride.DEFAULT);
                trip = RideTrip.from(model.studio(), RideMoment.start(model.studio()));
                whenBegun.run();
            }
        } else if (state.equals(new Idle(true))) {
            trip = RideTrip.from(trip.start(), moment());
        }
        run(Flying.coasting(false));
    }

    private void run(RideState next) {
        state = next;
        lastTick = System.nanoTime();
        timer.start();
    }

    private void goToStart(Ride ride) {
        unitsPerSecond = ride.lightSpeed();
        Studio start = ride.start(model.atHome());
        trip = RideTrip.from(start, RideMoment.start(start));
        state = new Idle(false);
        whenBegun.run();
        model.look(trip.moment().studio(), gesture);
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
        boolean kept = isRecording() && !trip.recorder().isEmpty();
        state = new Idle(isReplaying());
        if (kept) {
            RideRecorder recorder = trip.recorder();
            model.adjust(recorder.studio(), gesture);
            teller.accept(Texts.get("ride.recorded", String.format(Locale.ROOT, "%.1f", recorder.seconds())));
        }
        model.endGesture(gesture);
    }

    /** Begins to record, and to ride; or ends both. */
    public void setRecording(boolean recording) {
        setRiding(recording);
        if (recording) {
            trip = RideTrip.from(trip.start(), RideMoment.start(model.studio()));
            state = Flying.coasting(true);
            task.restart();
            tell();
        }
    }

    /** Whether there is something to replay. */
    public boolean canReplay() {
        return moment() == null
                ? !model.studio().ride().isEmpty()
                : !trip.start().ride().isEmpty() || !trip.recorder().isEmpty();
    }

    /** Where what can be replayed begins: the flight that the ride comes with, or what was flown; else the present. */
    public Studio beginning() {
        if (moment() == null) {
            return model.unmoved();
        }
        return trip.start().ride().isEmpty() ? trip.recorder().studio() : trip.start();
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
            RideFilm film = new RideFilm(beginning);
            RideMoment first = film.moment(0.0);
            trip = same ? trip.at(first) : RideTrip.from(beginning, first);
            run(new Replaying(film, 0));
            if (same) {
                task.restart();
            } else {
                task.begin(Ride.DEFAULT);
                whenBegun.run();
            }
            model.look(first.studio(), gesture);
        });
        tell();
    }

    private void tick(Pace pace) {
        long now = System.nanoTime();
        double seconds = Math.min(LONGEST_STEP_SECONDS, (now - lastTick) * 1e-9);
        lastTick = now;
        if (!follow(model.studio())) {
            setRiding(false);
            return;
        }
        attempt(() -> {
            if (state instanceof Flying flying) {
                fly(flying, seconds);
            } else if (state instanceof Replaying replaying) {
                Replaying next = replaying.after(seconds);
                state = next;
                go(next.film().moment(next.seconds()));
            }
            model.flow(trip.moment().studio(), gesture, pace);
            if (state instanceof Replaying replaying && replaying.isOver()) {
                setRiding(false);
            }
        });
    }

    /** Takes changes by others: another view or other lights are part of the ride, another place is not; false then. */
    private boolean follow(Studio studio) {
        boolean follows = isFlying() && trip.moment().isOf(studio);
        if (follows) {
            trip = trip.at(trip.moment().with(studio));
        }
        return follows || studio.equals(trip.moment().studio());
    }

    private void fly(Flying flying, double seconds) {
        double strength = RAPIDITY_PER_SECOND / unitsPerSecond;
        double properTime = unitsPerSecond * seconds;
        if (flying.brakes()) {
            double needed = trip.moment().rider().rapidity() / strength;
            double part = Math.min(needed, properTime);
            step(trip.moment().brake(strength), part);
            step(new Vector3d(), properTime - part);
        } else {
            double length = flying.wish().length();
            step(flying.wish().mul(length > 1 ? strength / length : strength, new Vector3d()), properTime);
        }
    }

    private void step(Vector3dc thrust, double properTime) {
        if (properTime > 0) {
            RideMoment before = trip.moment();
            RideMoment next = before.after(thrust, properTime);
            trip.recorder().add(before.studio(), thrust, properTime, properTime / unitsPerSecond, next.studio());
            go(next);
        }
    }

    private void go(RideMoment next) {
        boolean hasNews = task.follow(trip.moment(), next);
        trip = trip.at(next);
        if (hasNews) {
            teller.accept(task.verdict().text());
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
