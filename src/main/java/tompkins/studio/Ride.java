package tompkins.studio;

import java.util.List;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;

/** A ride that begins elsewhere than the photograph, and slower or faster. */
@Meaning("A ride with a start of its own: the window lets the camera of the photograph begin there")
public record Ride(
        @Meaning("What the ride is called") String name,

        @Meaning(value = "What to try on it, in a sentence", prose = true)
        String task,

        @Meaning(value = "Position of the lens at the start, in the scene frame", unit = "length")
        Vector3dc position,

        @Meaning(value = "Velocity at the start, in the scene frame", unit = "c")
        Velocity velocity,

        @Meaning(value = "How far light goes in a second of the ride, above 0", unit = "length")
        double lightSpeed,

        @Meaning("The ride, in legs that follow each other; empty if it is only steered by hand")
        List<RideLeg> legs,

        @Meaning(
                "What is to be reached, one after the other; the legs must show that it can be. Empty for no challenge")
        List<RideGoal> challenge) {

    /** A ride by hand, from rest at the origin. */
    public static final Ride DEFAULT = new Ride("Ride", "", new Vector3d(), Velocity.REST, 1, List.of(), List.of());

    /** Checks all values. */
    public Ride {
        position = Require.position("position", position);
        Velocity.required("velocity", velocity);
        Require.positive("lightSpeed", lightSpeed);
        legs = Require.list("legs", legs);
        challenge = Require.list("challenge", challenge);
    }

    /**
     * The studio with its camera at the start, at the time of its photograph, and with the legs of this ride.
     *
     * @throws tompkins.property.InvalidPropertyException if that is too far away
     */
    public Studio start(Studio studio) {
        double time = LensEvent.inScene(studio).time();
        Event start = new Event(position.x(), position.y(), position.z(), time);
        return LensEvent.moved(studio, start, velocity, new Quaterniond()).withRide(legs);
    }
}
