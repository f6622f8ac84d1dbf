package tompkins.trace;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import tompkins.camera.SamplePositions;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.RayCounts;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;

/** Which surfaces of a picture touch, as far as some of its rays find out that meet few surfaces. */
public final class TouchingSurfaces implements PathObserver {

    /** Number of rows, and of columns, of the grid of places in the picture that are tried. */
    private static final int TRIED = 24;

    private static final int DEPTH = 3;

    private final Set<String> media = new LinkedHashSet<>();
    private final Set<String> rivals = new LinkedHashSet<>();

    /** What touches in the picture of a plan. */
    public TouchingSurfaces(RenderPlan plan) {
        Studio studio = plan.studio();
        Studio simple = Descriptions.with(studio, "background", UniformBackground.DEFAULT)
                .withSettings(Descriptions.with(studio.settings(), "maximumDepth", DEPTH));
        SampleTracer tracer = RenderPlan.of(simple, plan).tracer(new RayCounts(), this);
        SamplePositions.spread(plan.width(), plan.height(), TRIED)
                .forEach(position -> tracer.sample(position.x(), position.y(), 0, 0, 0.5));
    }

    /** Which media meet at one boundary, in sentences. */
    public List<String> media() {
        return List.copyOf(media);
    }

    /** Of which opaque surfaces at one place only the first is seen, in clauses. */
    public List<String> rivals() {
        return List.copyOf(rivals);
    }

    @Override
    public void hits(Hit hit) {
        if (hit.contact == null) {
            return;
        }
        if (hit.contact.hits().size() > 1) {
            media.add(names(hit.contact.hits()) + " touch: their media meet at one boundary.");
        }
        if (hit.contact.rivals().size() > 1) {
            rivals.add(names(hit.contact.rivals()) + " lie at one place, and the first listed is seen");
        }
    }

    private static String names(List<Hit> hits) {
        return hits.stream()
                .map(each -> '"' + ((Primitive) each.boundary).description() + '"')
                .sorted()
                .collect(Collectors.joining(" and "));
    }
}
