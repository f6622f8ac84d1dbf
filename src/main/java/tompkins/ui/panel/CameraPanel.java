package tompkins.ui.panel;

import java.util.List;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.Aim;
import tompkins.camera.Camera;
import tompkins.camera.CameraMotion;
import tompkins.math.Vectors;
import tompkins.primitive.Bounds;
import tompkins.property.Require;
import tompkins.ray.Ray;
import tompkins.spacetime.Event;
import tompkins.spacetime.IdentityTransformation;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.studio.FrontWindow;
import tompkins.studio.LensEvent;
import tompkins.studio.Studio;
import tompkins.ui.model.StudioModel;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.NumberKind;
import tompkins.ui.widget.Numbers;
import tompkins.ui.widget.Part;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.VectorFields;

/**
 * Where the camera is and where it looks in the scene when the picture is taken; also in the camera frame, if that
 * differs.
 */
public final class CameraPanel extends Part {

    /** The most objects that are used to find the middle of the scene. */
    private static final int MOST_OBJECTS = 100_000;

    /** Digits of a place that was computed; the last are only rounding. */
    private static final int PLACE_DIGITS = 9;

    private static final Vector3dc UP = new Vector3d(0, 1, 0);

    private final StudioModel model;
    private final Supplier<Picture> shown;
    private final Note note = new Note("");
    private final Note inCamera = new Note("");
    private final VectorFields place;
    private final VectorFields view;

    /** A panel for the camera of a model; {@code shown} gives the picture on the screen. */
    public CameraPanel(StudioModel model, Supplier<Picture> shown) {
        super(Rows.column());
        this.model = model;
        this.shown = shown;
        place = new VectorFields(
                "place",
                NumberKind.DOUBLE,
                VectorFields.AXES,
                Texts.get("camera.placeTip"),
                note,
                vector -> model.set(LensEvent.moved(model.studio(), vector)));
        view = new VectorFields(
                "viewDirection",
                NumberKind.DOUBLE,
                VectorFields.AXES,
                Texts.get("camera.viewTip"),
                note,
                vector -> look(inCamera(Require.direction("viewDirection", vector))));
        addRow("camera.place", place);
        addRow("camera.view", view);
        panel.add(note.component(), "wmin 0");
        panel.add(inCamera.component(), "wmin 0");
        panel.add(new JLabel(Texts.get("camera.look")));
        panel.add(buttons(), "wmin 0");
        model.follow(this::update);
    }

    private void addRow(String key, VectorFields fields) {
        panel.add(new JLabel(Texts.get(key)));
        JPanel row = Rows.of("gap 4", "[grow,fill][grow,fill][grow,fill]");
        fields.addInRow(row);
        panel.add(row, "wmin 0");
    }

    private JComponent buttons() {
        JPanel row = Rows.of("wrap 2, gap 4", "[grow,fill,sg][grow,fill,sg]");
        row.add(button("ahead", () -> look(model.studio().velocity().direction())));
        row.add(button(
                "back", () -> look(new Vector3d().sub(model.studio().velocity().direction()))));
        row.add(button("middle", this::lookAtMiddle));
        row.add(button("level", this::level));
        row.add(button("home", this::goHome), "span 2");
        return row;
    }

    private JButton button(String key, Runnable action) {
        return Buttons.of("camera." + key, () -> {
            note.setText("");
            action.run();
        });
    }

    private void hold(Camera camera) {
        note.attempt(() -> model.set(FrontWindow.held(model.studio(), camera)));
    }

    /** Looks along a direction of the camera frame. */
    private void look(Vector3dc direction) {
        hold(Aim.along(model.studio().camera(), direction));
    }

    /** The direction in the camera frame of what is seen along a direction of the scene frame. */
    private Vector3d inCamera(Vector3dc inScene) {
        return turned(model.studio().sceneFromCamera().inverse(), inScene);
    }

    private static Vector3d turned(SpaceTimeTransformation change, Vector3dc direction) {
        Vector3d unit = Vectors.unit(direction);
        Ray ray = change.transform(Ray.from(0, 0, 0, unit.x, unit.y, unit.z, 0));
        return new Vector3d(ray.dx, ray.dy, ray.dz);
    }

    private void lookAtMiddle() {
        Picture picture = shown.get();
        List<Bounds> boxes = picture == null ? List.of() : picture.plan().sceneBounds(MOST_OBJECTS);
        if (boxes.isEmpty()) {
            note.setError(Texts.get("camera.nothing"));
            return;
        }
        Bounds all = boxes.stream().reduce(Bounds::with).orElseThrow();
        Vector3d way = all.centre().sub(LensEvent.inScene(model.studio()).position());
        if (way.length() > 0) {
            look(inCamera(way));
        }
    }

    /** Makes the y axis of the scene point up in the picture, and looks at the horizon. */
    private void level() {
        Camera camera = model.studio().camera();
        Vector3d view = new Vector3d(camera.viewDirection());
        view.y = 0;
        if (view.length() < 1e-9 * camera.viewDirection().length()) {
            // straight up or down: towards what was at the lower or the upper edge of the picture
            view.set(camera.upDirection()).mul(camera.viewDirection().y() > 0 ? -1 : 1).y = 0;
        }
        hold(CameraMotion.turned(camera, Vectors.unit(view), UP));
    }

    private void goHome() {
        Studio home = model.opened();
        model.set(model.studio()
                .withCamera(home.camera())
                .withCameraFrame(home.cameraFrame())
                .withVelocity(home.velocity()));
    }

    private void update() {
        Studio studio = model.studio();
        Camera camera = studio.camera();
        SpaceTimeTransformation sceneFromCamera = studio.sceneFromCamera();
        Event lens = LensEvent.inScene(studio);
        place.show(Numbers.rounded(lens.position(), PLACE_DIGITS));
        Vector3d inScene = turned(sceneFromCamera, camera.viewDirection());
        boolean isSeen = inScene.isFinite() && inScene.length() > 0;
        view.showDirection(isSeen ? inScene : camera.viewDirection());
        inCamera.setText(
                sceneFromCamera instanceof IdentityTransformation
                        ? ""
                        : Texts.get(
                                "camera.inCamera",
                                Numbers.brief(camera.position()),
                                Numbers.brief(LensEvent.inCamera(studio).time()),
                                Numbers.brief(Vectors.unit(camera.viewDirection()))));
    }
}
