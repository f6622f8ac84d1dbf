package tompkins.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.property.NumberText;
import tompkins.trace.FlashSight;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.world.LitSpan;

/** Says what flash lamps do in a picture, and when something in it is lit. */
public final class Flashes {

    /** Number of rows, and of columns, of the grid of places in the picture that are tried. */
    private static final int TRIED = 16;

    /** Light that comes so many times later than that of half the picture counts as gone: floors are lit for ever. */
    private static final double LATE = 3;

    private static final int DIGITS = 6;

    private final RenderPlan plan;
    private final List<RestingLight> lamps;

    /** The flashes of the picture that is planned. */
    public Flashes(RenderPlan plan) {
        this.plan = plan;
        lamps = plan.world().lights();
    }

    /** A sentence or some for each lamp that flashes, or one for all if none could light what is in the middle. */
    List<String> sentences() {
        List<FlashSight> sights = middle();
        return plan.hasFlashes() && sights.isEmpty()
                ? List.of("Lamps flash, but the middle of the picture shows nothing that they could light.")
                : sights.stream().map(this::sentence).toList();
    }

    /** What may be wrong, in a clause. */
    Optional<String> warning() {
        boolean onlyFlashes =
                lamps.stream().allMatch(light -> !(light instanceof PointLight) || light.flash() instanceof Pulse);
        return onlyFlashes && plan.hasFlashes() && tried().noneMatch(this::mayBeLit)
                ? Optional.of("no flash lights anything in the picture at this opening time"
                        + litTimes()
                                .map(times -> ": something is lit " + fromTo(times))
                                .orElse(""))
                : Optional.empty();
    }

    /**
     * The opening times from the first at which a flash lights something in the picture to one at which most of it is
     * dark again, judged by what is seen now; none if nothing is ever lit.
     */
    public Optional<LitSpan> litTimes() {
        List<LitSpan> spans = tried().filter(FlashSight::isClear)
                .map(this::openingTimes)
                .filter(times -> !times.isEmpty())
                .map(times -> times.get(0))
                .filter(span -> Double.isFinite(span.from()) && Double.isFinite(span.to()))
                .toList();
        if (spans.isEmpty() || !hasOpeningTime()) {
            return Optional.empty();
        }
        double first = spans.stream().mapToDouble(LitSpan::from).min().getAsDouble();
        double[] ends = spans.stream().mapToDouble(LitSpan::to).sorted().toArray();
        double latest = first + LATE * (ends[ends.length / 2] - first);
        return Optional.of(new LitSpan(first, Math.min(latest, ends[ends.length - 1])));
    }

    /** The flashes at all hits of rays that are spread over the picture. */
    private Stream<FlashSight> tried() {
        return SampleHistory.hits(plan, TRIED).flatMap(hit -> hit.flashes().stream());
    }

    private boolean isLit(FlashSight sight) {
        double now = now();
        return sight.isClear()
                && (sight.isLit()
                        || openingTimes(sight).stream().anyMatch(times -> times.from() <= now && now < times.to()));
    }

    /** Whether something is lit, or no opening times are known for it, because it is behind a mirror or glass. */
    private boolean mayBeLit(FlashSight sight) {
        return isLit(sight) || sight.isClear() && !sight.isStraight() && plan.blursInTime();
    }

    private List<FlashSight> middle() {
        SampleHistory middle = plan.hasFlashes() ? plan.middleHistory() : null;
        return middle == null || middle.end() == null ? List.of() : middle.end().flashes();
    }

    private String sentence(FlashSight sight) {
        Pulse flash = sight.flash();
        String again = flash.period() == 0 ? "" : ", and again every " + NumberText.of(flash.period());
        return "Lamp " + sight.lamp() + " flashes for " + NumberText.of(flash.duration()) + " at "
                + NumberText.of(flash.start()) + " of its own time" + again + ". " + middle(sight);
    }

    /** With which opening times the middle is lit; {@code trace} tells when the light left the lamp. */
    private String middle(FlashSight sight) {
        if (!sight.isClear()) {
            return "Its light does not reach what the middle of the picture shows.";
        }
        List<LitSpan> times = hasOpeningTime() ? openingTimes(sight) : List.of();
        String middle = "The middle of the picture " + (isLit(sight) ? "is" : times.isEmpty() ? "is not" : "would be");
        return times.isEmpty()
                ? middle + " lit now."
                : middle + " lit " + times.stream().map(Flashes::fromTo).collect(Collectors.joining(" and ")) + " (now "
                        + NumberText.plain(now(), DIGITS) + "), while it shows that surface.";
    }

    private boolean hasOpeningTime() {
        return plan.studio().camera().shutter().hasOpeningTime();
    }

    private double now() {
        return hasOpeningTime() ? plan.studio().camera().shutter().openingTime() : 0;
    }

    /**
     * The opening times with which a hit is lit in some part of the exposure; of a lamp that flashes again and again,
     * those around the present one or nearest to it.
     */
    private List<LitSpan> openingTimes(FlashSight sight) {
        double exposure = plan.studio().camera().exposureTime();
        double now = now();
        List<LitSpan> joined = new ArrayList<>();
        sight.spans().stream().sorted(Comparator.comparingDouble(LitSpan::from)).forEach(span -> {
            double from = now + span.from() - exposure / 2;
            double to = now + span.to() + exposure / 2;
            LitSpan last = joined.isEmpty() ? null : joined.get(joined.size() - 1);
            if (last != null && from <= last.to()) {
                joined.set(joined.size() - 1, new LitSpan(last.from(), Math.max(last.to(), to)));
            } else {
                joined.add(new LitSpan(from, to));
            }
        });
        return sight.flash().period() == 0
                ? joined
                : joined.stream()
                        .min(Comparator.comparingDouble(
                                times -> Math.max(0, Math.max(times.from() - now, now - times.to()))))
                        .stream()
                        .toList();
    }

    private static String fromTo(LitSpan times) {
        return "with an opening time from " + NumberText.plain(times.from(), DIGITS)
                + (Double.isInfinite(times.to()) ? " on" : " to " + NumberText.plain(times.to(), DIGITS));
    }
}
