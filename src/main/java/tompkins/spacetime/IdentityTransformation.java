package tompkins.spacetime;

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

    @Override
    public SpaceTimeTransformation inverse() {
        return this;
    }
}
