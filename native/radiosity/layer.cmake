gg_layer(radiosity
         SOURCES arrival.cpp cluster_tree.cpp creases.cpp element_light.cpp exchange.cpp exposure.cpp face_groups.cpp gathered_light.cpp gather_places.cpp gather_rays.cpp
                 face_sampling.cpp faces.cpp gather.cpp hierarchy.cpp instance_parts.cpp
                 interpolation.cpp large_faces.cpp leaf_cluster.cpp lighting.cpp link_estimate.cpp make_nodes.cpp mesh_balance.cpp near_link.cpp
                 open_elements.cpp opinions.cpp oracle.cpp patches.cpp push_pull.cpp reference_white.cpp refine.cpp seen_light.cpp separators.cpp shadow_edges.cpp shadow_rays.cpp sky_balance.cpp solution.cpp solve.cpp source_guide.cpp source_rays.cpp surface_mesh.cpp t_vertices.cpp
         LINKS gg_transport gg_trace gg_material gg_scene gg_core)
