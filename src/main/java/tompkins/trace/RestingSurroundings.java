package tompkins.trace;

import java.util.List;
import tompkins.light.Sightline;
import tompkins.primitive.Primitive;
import tompkins.ray.Colour;
import tompkins.ray.Contact;
import tompkins.ray.Hit;
import tompkins.ray.Padded;
import tompkins.ray.Ray;
import tompkins.ray.RayCounts;
import tompkins.ray.RayPacket;
import tompkins.search.ContactSearch;
import tompkins.search.LampShadows;
import tompkins.search.NearestHit;
import tompkins.search.ObjectTree;
import tompkins.search.PacketSearch;
import tompkins.spacetime.TransformationLaw;
import tompkins.world.Lamp;

/** The objects and lamps of one frame, in which nothing moves. */
final class RestingSurroundings extends Padded implements Surroundings {

    private final ObjectTree objects;
    private final List<Lamp> lamps;
    private final RayCounts counts;
    private final NearestHit nearest;
    private final PacketSearch packet;
    private final Ray memory = Ray.blank();

    /** The ray whose hit was found last, and the surfaces there; null if there is only one. */
    private Ray met;

    private Contact contact;

    /** What threw the last shadow: it often throws the next one, too. */
    private Primitive lastShadow;

    /** The surroundings in a frame. */
    RestingSurroundings(ObjectTree objects, List<Lamp> lamps, RayCounts counts) {
        this.objects = objects;
        this.lamps = lamps;
        this.counts = counts;
        nearest = new NearestHit(counts);
        packet = new PacketSearch(objects, nearest);
    }

    @Override
    public void begin(RayPacket rays) {
        lastShadow = null;
        packet.begin(rays);
    }

    @Override
    public boolean mayMeet(int place) {
        return packet.mayMeet(place);
    }

    @Override
    public boolean nearest(int place) {
        return packet.nearest(place, Primitive.NO_HIT) && meets(packet.ray());
    }

    @Override
    public Ray met() {
        return met;
    }

    @Override
    public boolean nearest(Ray ray) {
        contact = ray.contact == null ? null : ray.contact.next();
        if (contact != null) {
            met = ray;
            return true;
        }
        return objects.nearest(ray, nearest) && meets(ray);
    }

    /** Whether a ray meets something at a place that was found: all surfaces there may be one that does nothing. */
    private boolean meets(Ray ray) {
        met = ray;
        contact = null;
        if (!nearest.isShared()) {
            return true;
        }
        ContactSearch search = new ContactSearch();
        search.add(objects, ray, nearest.reach());
        Contact all = search.contact();
        contact = all == null ? null : all.next();
        return all == null || contact != null || nearest(ray.past(nearest.hit(ray, Hit.blank()), all));
    }

    @Override
    public TransformationLaw law() {
        return TransformationLaw.NONE;
    }

    @Override
    public Hit hit(Hit hitMemory) {
        return contact == null ? nearest.hit(met, hitMemory) : contact.hit();
    }

    @Override
    public Ray goesOn(Ray next, Colour weight) {
        return next;
    }

    @Override
    public Ray leaving(Ray ray) {
        return ray;
    }

    @Override
    public boolean find(int source, Hit hit, Sightline sight) {
        lamps.get(source).find(hit, sight);
        return true;
    }

    @Override
    public boolean isClear(int source, Hit from, Sightline sight) {
        counts.shadowRays++;
        double distance = sight.length;
        Ray ray = memory.setShadow(from, sight.x / distance, sight.y / distance, sight.z / distance);
        if (ContactSearch.isInShadow(ray)) {
            return false;
        }
        LampShadows seen = lamps.get(source).shadows();
        if (seen != null) {
            return !seen.shadows(from, ray, 0, distance, counts);
        }
        if (lastShadow != null && lastShadow.shadows(ray, distance)) {
            return false;
        }
        lastShadow = objects.shadow(ray, distance, nearest);
        return lastShadow == null;
    }

    /** Light is shifted on its way into the camera frame, if at all. */
    @Override
    public boolean shifts() {
        return false;
    }

    @Override
    public Colour seen(Colour light, Ray ray, double dopplerFactor) {
        return light;
    }
}
