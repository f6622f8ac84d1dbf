package tompkins.ui.ray;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import tompkins.io.FactText;
import tompkins.measure.RayHistory;
import tompkins.measure.RayTubes;
import tompkins.primitive.Described;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.trace.Frame;
import tompkins.trace.SampleHistory;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.ChoiceRow;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;

/** The life of the ray of a pinned pixel, in a part of the side panel that is there only while a pixel is pinned. */
public final class RaySection extends Part {

    /** The size of the diagram, in sizes of the type. */
    private static final double DIAGRAM = 12.5;

    private final StudioModel model;
    private final Runnable unpin;
    private final Consumer<Consumer<List<SampleHistory>>> cones;
    private final Consumer<StudioPath> editor;
    private final StoryPane story = new StoryPane();
    private final DiagramPane diagram = new DiagramPane(DIAGRAM);
    private final DiagramWindow large = new DiagramWindow();
    private final JComponent frames = ChoiceRow.of(
            List.of(Frame.SCENE, Frame.CAMERA),
            each -> Texts.get("ray.diagram." + each),
            each -> Texts.get("ray.diagram." + each + ".choose"),
            this::draw);
    private Frame frame = Frame.SCENE;
    private final JButton edit = Buttons.of("ray.edit", this::edit);

    /** The pinned ray, if it has a life. */
    private List<SampleHistory> rays = List.of();

    private final JButton drawRay = Buttons.of("ray.draw", () -> draw("ray", rays));
    private final JButton drawCone = Buttons.of("ray.cone", this::drawCone);

    /** What is photographed in its picture; null if nothing is pinned. */
    private Studio studio;

    private String pixel;

    /**
     * A section.
     *
     * @param unpin unpins the pixel
     * @param cones follows a cone of rays around the pinned one for those whom it is given
     * @param editor opens the editor for an object that the ray hit
     */
    public RaySection(
            StudioModel model,
            Runnable unpin,
            Consumer<Consumer<List<SampleHistory>>> cones,
            Consumer<StudioPath> editor) {
        super(Rows.column());
        this.model = model;
        this.unpin = unpin;
        this.cones = cones;
        this.editor = editor;
        story.setName("ray.story");
        story.getAccessibleContext().setAccessibleName(Texts.get("ray.title"));
        JButton button = new JButton(Texts.get("ray.unpin"));
        button.setName(Texts.get("ray.unpin"));
        button.addActionListener(event -> unpin.run());
        JPanel buttons = Rows.of("gap 4 6, wrap 2", "[][]push");
        buttons.add(edit);
        buttons.add(button);
        buttons.add(drawRay);
        buttons.add(drawCone);
        buttons.add(Buttons.of("ray.enlarge", () -> large.open(component())));
        JLabel title = new JLabel(Texts.get("ray.title"));
        title.putClientProperty(FlatClientProperties.STYLE, "font: bold");
        panel.add(title);
        panel.add(frames, "wmin 0");
        panel.add(diagram, "wmin 0");
        panel.add(story, "wmin 0");
        panel.add(buttons, "wmin 0");
        panel.setVisible(false);
    }

    /**
     * Shows a ray, or nothing if it is null.
     *
     * @param picture name of the picture to which the ray belongs, or null if it is the studio's
     */
    public void show(PixelReading reading, String picture) {
        panel.setVisible(reading != null);
        // an unpinned ray must not keep its scene in memory
        SampleHistory life = reading == null ? null : reading.sighting().life();
        rays = life == null ? List.of() : List.of(life);
        edit.setEnabled(object().isPresent());
        drawRay.setEnabled(RayTubes.canDraw(rays));
        drawCone.setEnabled(RayTubes.canDraw(rays));
        studio = reading == null ? null : reading.sighting().studio();
        frames.setVisible(!rays.isEmpty());
        draw(frame);
        if (reading != null) {
            pixel = Texts.get("probe.pixel", reading.column(), reading.row());
            story.show(Stream.concat(
                            Stream.of(
                                    new FactText.Line(
                                            0,
                                            true,
                                            picture == null ? pixel : Texts.get("ray.other", pixel, picture),
                                            ""),
                                    new FactText.Line(0, false, Texts.get("ray.followed"), Texts.get("ray.backwards"))),
                            FactText.SIGNS.lines(RayHistory.of(reading.sighting())))
                    .toList());
        }
    }

    private void draw(Frame upright) {
        frame = upright;
        SpaceTimeDiagram drawn = rays.isEmpty() ? null : SpaceTimeDiagram.of(rays.get(0), studio, frame);
        String text = Texts.get("ray.diagram." + frame + ".tip");
        diagram.show(drawn, text);
        large.show(drawn, text);
    }

    /** The first object that the ray hit and that the studio still holds. */
    private Optional<StudioPath> object() {
        // glass is hit again and again, and finding it in a large scene takes time
        Set<Described> sought = Collections.newSetFromMap(new IdentityHashMap<>());
        return rays.stream()
                .flatMap(ray -> ray.hits().stream())
                .map(SampleHistory.Encounter::object)
                .filter(sought::add)
                .flatMap(object -> StudioPath.to(model.studio(), object).stream())
                .findFirst();
    }

    private void drawCone() {
        cones.accept(around -> {
            // a pixel of the picture may have gone meanwhile
            if (RayTubes.canDraw(around)) {
                draw("cone", around);
            }
        });
    }

    /** Draws rays in one step that can be undone. Their pixel shows the end of a rod now, and so is no more pinned. */
    private void draw(String kind, List<SampleHistory> drawn) {
        String name = Texts.get("ray.drawn." + kind, pixel);
        unpin.run();
        model.set(RayTubes.addedTo(model.studio(), name, drawn));
    }

    private void edit() {
        Optional<StudioPath> object = object();
        // it may have been deleted since
        edit.setEnabled(object.isPresent());
        object.ifPresent(editor);
    }
}
