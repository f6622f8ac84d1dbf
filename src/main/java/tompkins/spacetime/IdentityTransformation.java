package tompkins.spacetime;

import org.joml.Vector3dc;
import tompkins.ray.Ray;
import tompkins.ray.RayPacket;

/** No change: both frames are one. */
public record IdentityTransformation() implements SpaceTimeTransformation {

    @Override
    public Event transform(Event event) {
        return event;
    }

    @Override
    public PreciseEvent transform(PreciseEvent event) {
        return event;
    }

    @Override
    public Ray transform(Ray ray, Ray memory) {
        return memory == ray ? ray : memory.set(ray);
    }

    @Override
    public void transform(RayPacket rays) {}

    /** 0: every event keeps its place, so the time is free; 0 is the limit of small velocities. */
    @Override
    public double fixedPointTime(Vector3dc position) {
        return 0;
    }

    @Override
    public SpaceTimeTransformation inverse() {
        return this;
    }
}
